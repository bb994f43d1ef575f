// region: 2
// What k sweeps leave, sweep by sweep.
  real left = 1;
  for (int sweep = 0; sweep < sweeps; ++sweep) left *= rho;
  return left < 1 / (1 + beta);
