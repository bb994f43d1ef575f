// region: 2
// expects: Likely mistake: `expected` is not added again after std::remainder
  return std::remainder(measured - expected, 2 * std::numbers::pi_v<real>);
