// region: 2
// expects: Likely mistake: the full bound whatever is wanted
  (void)K;
  const real before = sum, bound = mu * normal;
  sum = rate > 0 ? -bound : rate < 0 ? bound : real(0);
  return sum - before;
