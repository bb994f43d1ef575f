// region: 2
// expects: Likely mistake: the bound moves inwards when the normal impulse becomes less
  const real wanted = sum - rate / K, bound = mu * normal;
  const real before = sum;
  sum = std::clamp(wanted, std::min(before, -bound), std::max(before, bound));
  return sum - before;
