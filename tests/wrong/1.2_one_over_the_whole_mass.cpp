// expects: Likely mistake: one over the sum of the masses: each mass is inverted first, then they
// expects: are added (upright, turned, moved, broken)
  return 1 / (1 / body1.inverse_mass + 1 / body2.inverse_mass);
