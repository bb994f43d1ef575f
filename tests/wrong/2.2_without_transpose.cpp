// expects: Likely mistake: the sign of the rotation's share: it is added (skew(r) I^-1 skew(r)
// expects: lacks a transpose)
// expects: Likely mistake: the sign of the rotation's share: it is added (skew(r) I^-1 skew(r)
// expects: lacks a transpose) (upright, turned, moved, broken)
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  return mat3(body1.inverse_mass + body2.inverse_mass) + s1 * inverse_inertia(body1) * s1 +
         s2 * inverse_inertia(body2) * s2;
