// region: 2
// expects: Likely mistake: times K where it must be divided by K
  const real wanted = sum - rate * K, bound = mu * normal;
  const real before = sum;
  sum = std::clamp(wanted, -bound, bound);
  return sum - before;
