// region: 2
// expects: Likely mistake: always the same bound
  (void)rate;
  (void)K;
  const real before = sum;
  sum = -mu * normal;
  return sum - before;
