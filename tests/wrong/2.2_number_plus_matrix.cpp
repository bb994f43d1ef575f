// expects: Likely mistake: a matrix plus a number adds it to all nine entries: write mat3(a)
// expects: (upright, turned, moved, broken)
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  return (body1.inverse_mass + body2.inverse_mass) +
         s1 * inverse_inertia(body1) * transpose(s1) +
         s2 * inverse_inertia(body2) * transpose(s2);
