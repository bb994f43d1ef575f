// region: 2
// expects: Likely mistake: K is missing: an impulse is a speed divided by K
  (void)K;
  const real wanted = sum - rate, bound = mu * normal;
  const real before = sum;
  sum = std::clamp(wanted, -bound, bound);
  return sum - before;
