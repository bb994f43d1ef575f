// region: 2
// expects: Likely mistake: only the upper bound is there: friction is bounded either way
  const real before = sum;
  sum = std::min(sum - rate / K, mu * normal);
  return sum - before;
