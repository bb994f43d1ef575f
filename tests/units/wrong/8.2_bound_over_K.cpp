// region: 2
// expects: Units: in the change of the sum, comparing kg^2 m/s with kg m/s
  const real wanted = sum - rate / K, bound = mu * normal / K, before = sum;
  sum = std::clamp(wanted, -bound, bound);
  return sum - before;
