// region: 2
// expects: Likely mistake: the bound moves inwards when the normal impulse becomes less
  const real wanted = sum - rate / K, bound = mu * normal;
  if (std::abs(wanted) > bound) return 0;
  const real before = sum;
  sum = wanted;
  return sum - before;
