// region: 2
// expects: Likely mistake: what was wanted is returned
  const real wanted = sum - rate / K, bound = mu * normal;
  const real before = sum;
  sum = std::clamp(wanted, -bound, bound);
  return wanted - before;
