// expects: Likely mistake: the sign: body 2 has -skew(r2) in the point and E in the lock: a minus
  const vec3 r1 = to_world(body1, point.anchor1_local), r2 = to_world(body2, point.anchor2_local);
  return skew(r1) * inverse_inertia(body1) + skew(r2) * inverse_inertia(body2);
