// region: 2
// expects: Likely mistake: the bound is mu times the normal impulse: mu is missing
  (void)mu;
  const real wanted = sum - rate / K, bound = normal;
  const real before = sum;
  sum = std::clamp(wanted, -bound, bound);
  return sum - before;
