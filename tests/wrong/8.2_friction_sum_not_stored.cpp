// region: 2
// expects: Likely mistake: the sum is not stored
  const real bound = mu * normal;
  return std::clamp(sum - rate / K, -bound, bound) - sum;
