// expects: Units: in K, adding kg m^4 to 1/kg: inertia where its inverse belongs
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  return mat3(body1.inverse_mass + body2.inverse_mass) +
         s1 * inverse(inverse_inertia(body1)) * transpose(s1) +
         s2 * inverse(inverse_inertia(body2)) * transpose(s2);
