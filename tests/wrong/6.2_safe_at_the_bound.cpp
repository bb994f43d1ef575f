// region: 2
// expects: rho 0.5 sweeps 1 beta 1
// expects: Likely mistake: at the bound nothing dies away
  return std::pow(rho, real(sweeps)) * (1 + beta) <= 1;
