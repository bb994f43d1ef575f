// region: 3
// 2 to the power x is e to the power x ln 2.
  return -std::expm1(-std::log(real(2)) * h / half_time);
