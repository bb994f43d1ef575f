// expects: lambda kept (on paper).y
// expects: Likely mistake: the ratio is forgotten
  apply_impulse(J, lambda, body1, body2);
