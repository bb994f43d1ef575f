// region: 2
// The product written out: what is left, and what beta adds to it.
  const real left = std::pow(rho, real(sweeps));
  return !(left + beta * left >= 1);
