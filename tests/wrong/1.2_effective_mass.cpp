// expects: Likely mistake: the inverse of K: that is the effective mass, the solver inverts K
// expects: itself (upright, turned, moved, broken)
  return 1 / (body1.inverse_mass + body2.inverse_mass);
