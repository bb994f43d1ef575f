// expects: change of v2 (on paper).y
// expects: Likely mistake: the old impulse is applied and the scaled one is kept
  apply_impulse(J, lambda, body1, body2);
  lambda *= ratio;
