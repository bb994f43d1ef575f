// region: 2
// expects: Likely mistake: the new sum is added to the old one
  const real bound = mu * normal, next = std::clamp(sum - rate / K, -bound, bound);
  const real change = next - sum;
  sum += next;
  return change;
