// region: 2
// expects: Likely mistake: only the lower bound is there: friction is bounded either way
  const real before = sum;
  sum = std::max(sum - rate / K, -mu * normal);
  return sum - before;
