// region: 2
// expects: rho 0.975528 sweeps 4 beta 0.15
// expects: Likely mistake: 1 is forgotten
  return std::pow(rho, real(sweeps)) < 1 / beta;
