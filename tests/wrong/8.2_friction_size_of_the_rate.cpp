// region: 2
// expects: Likely mistake: the sign of the rate is lost
  const real wanted = sum - std::abs(rate) / K, bound = mu * normal;
  const real before = sum;
  sum = std::clamp(wanted, -bound, bound);
  return sum - before;
