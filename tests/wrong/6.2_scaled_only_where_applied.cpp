// expects: Likely mistake: the scaled impulse is applied and the old one is kept
  apply_impulse(J, ratio * lambda, body1, body2);
