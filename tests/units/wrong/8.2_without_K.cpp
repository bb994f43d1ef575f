// region: 2
// expects: Units: in the change of the sum, taking m/s from kg m/s: the inverse mass is missing
  const real wanted = sum - rate, bound = mu * normal, before = sum;
  sum = std::clamp(wanted, -bound, bound);
  (void)K;
  return sum - before;
