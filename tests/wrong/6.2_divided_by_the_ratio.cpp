// expects: Likely mistake: divided by the ratio
  lambda /= ratio;
  apply_impulse(J, lambda, body1, body2);
