// region: 2
// expects: std::clamp(a, low, high) was given a high that is below low
  const real wanted = sum - rate / K, bound = mu * normal;
  const real before = sum;
  sum = std::clamp(wanted, bound, -bound);
  return sum - before;
