// expects: lambda kept (on paper).y
// expects: Likely mistake: lambda is set to zero: it must hold what has been applied
  apply_impulse(J, ratio * lambda, body1, body2);
  lambda = vec3(0);
