// region: 2
// expects: Likely mistake: this is what a row does that only pushes
  (void)mu;
  (void)normal;
  const real before = sum;
  sum = std::max(real(0), sum - rate / K);
  return sum - before;
