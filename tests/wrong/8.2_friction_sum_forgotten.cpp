// region: 2
// expects: Likely mistake: the sum so far is missing in what is wanted
  const real wanted = -rate / K, bound = mu * normal;
  const real before = sum;
  sum = std::clamp(wanted, -bound, bound);
  return sum - before;
