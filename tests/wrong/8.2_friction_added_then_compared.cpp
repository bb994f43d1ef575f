// region: 2
// expects: Likely mistake: the new sum is added to the old one
  const real bound = mu * normal, next = std::clamp(sum - rate / K, -bound, bound);
  sum += next;
  return next - sum;
