// region: 2
// expects: Likely mistake: the full bound whatever is wanted
  (void)K;
  const real before = sum;
  sum = (rate > 0 ? -1 : 1) * mu * normal;
  return sum - before;
