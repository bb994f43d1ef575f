// region: 3
// expects: Units: in beta, the exponential of 1/s
  return 1 - std::exp2(-1 / half_time);
