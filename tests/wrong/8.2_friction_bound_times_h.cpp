// region: 2
// expects: Likely mistake: the bound is an impulse already
  const real wanted = sum - rate / K, bound = mu * normal / 20;
  const real before = sum;
  sum = std::clamp(wanted, -bound, bound);
  return sum - before;
