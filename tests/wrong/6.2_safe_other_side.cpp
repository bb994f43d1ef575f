// region: 2
// expects: Likely mistake: the sign of beta, or 1 + beta stands on the other side
  return std::pow(rho, real(sweeps)) < 1 + beta;
