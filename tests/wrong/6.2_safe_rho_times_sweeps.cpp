// region: 2
// expects: Likely mistake: rho times k
  return rho * real(sweeps) * (1 + beta) < 1;
