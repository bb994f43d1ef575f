// region: 2
// expects: Likely mistake: the new sum is returned instead of its change
  const real bound = mu * normal;
  sum = std::clamp(sum - rate / K, -bound, bound);
  return sum;
