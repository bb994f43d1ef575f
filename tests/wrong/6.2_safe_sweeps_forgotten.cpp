// region: 2
// expects: rho 0.975528 sweeps 6 beta 0.15
// expects: Likely mistake: the sweeps are forgotten
  return rho * (1 + beta) < 1;
