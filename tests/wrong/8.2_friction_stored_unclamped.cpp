// region: 2
// expects: Likely mistake: the sum that is stored is not clamped
  const real wanted = sum - rate / K, bound = mu * normal, before = sum;
  sum = wanted;
  return std::clamp(wanted, -bound, bound) - before;
