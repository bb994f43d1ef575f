// The larger of -bound and the smaller of what is wanted and the bound.
// region: 2
  const real before = sum;
  sum = std::max(-mu * normal, std::min(mu * normal, sum - rate / K));
  return sum - before;
