// expects: change of v1 (equal steps)
// expects: Likely mistake: nothing is applied where the step has not changed
  if (ratio == 1) return;
  lambda *= ratio;
  apply_impulse(J, lambda, body1, body2);
