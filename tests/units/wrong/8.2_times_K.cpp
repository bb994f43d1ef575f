// region: 2
// expects: Units: in the change of the sum, taking m/(kg s) from kg m/s
  const real wanted = sum - rate * K, bound = mu * normal, before = sum;
  sum = std::clamp(wanted, -bound, bound);
  return sum - before;
