// region: 2
// expects: Likely mistake: the bound is mu times the normal impulse: normal is missing
  (void)normal;
  const real wanted = sum - rate / K, bound = mu;
  const real before = sum;
  sum = std::clamp(wanted, -bound, bound);
  return sum - before;
