// expects: Likely mistake: the share of the rotation is missing (upright, turned, moved, broken)
  return mat3(body1.inverse_mass + body2.inverse_mass);
