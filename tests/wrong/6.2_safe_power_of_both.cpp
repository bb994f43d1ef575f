// region: 2
// expects: Or 1 + beta has the power k, too: only rho has it
  return std::pow(rho * (1 + beta), real(sweeps)) < 1;
