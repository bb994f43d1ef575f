// region: 2
// expects: Units: in K, adding 1/(kg m^2) to 1/kg: the arms are missing
  const vec3 n = direction(world_point(body2, anchor2_local) - world_point(body1, anchor1_local));
  return body1.inverse_mass + body2.inverse_mass + dot(n, inverse_inertia(body1) * n) +
         dot(n, inverse_inertia(body2) * n);
