// region: 2
// expects: Likely mistake: the new sum is added to the old one
  const real bound = mu * normal, now = std::clamp(sum - rate / K, -bound, bound);
  sum += now;
  return now;
