// region: 2
// expects: Likely mistake: the sign of beta
  return std::pow(rho, real(sweeps)) * (1 - beta) < 1;
