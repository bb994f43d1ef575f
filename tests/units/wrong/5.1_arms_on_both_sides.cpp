// expects: Units: X is in 1/kg and should be in 1/(kg m): a length too many
  const mat3 s1 = skew(to_world(body1, point.anchor1_local));
  const mat3 s2 = skew(to_world(body2, point.anchor2_local));
  return s1 * inverse_inertia(body1) * s1 + s2 * inverse_inertia(body2) * s2;
