// The change is clamped, between what is left of the bound on both sides.
// region: 2
  const real bound = mu * normal;
  const real change = std::clamp(-rate / K, -bound - sum, bound - sum);
  sum += change;
  return change;
