// region: 2
// expects: Likely mistake: the bound is divided by K
  const real wanted = sum - rate / K, bound = mu * normal / K;
  const real before = sum;
  sum = std::clamp(wanted, -bound, bound);
  return sum - before;
