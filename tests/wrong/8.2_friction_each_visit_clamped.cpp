// region: 2
// expects: Likely mistake: the change of each visit is clamped
  const real bound = mu * normal, change = std::clamp(-rate / K, -bound, bound);
  sum += change;
  return change;
