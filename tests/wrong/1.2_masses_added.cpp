// expects: Likely mistake: masses where inverse masses belong: K is in 1/kg (upright, turned,
// expects: moved, broken)
  return 1 / body1.inverse_mass + 1 / body2.inverse_mass;  // the thesis' m1 + m2 (E19)
