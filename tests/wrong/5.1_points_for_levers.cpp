// expects: Likely mistake: a point where a lever belongs
  const vec3 p1 = world_point(body1, point.anchor1_local);
  const vec3 p2 = world_point(body2, point.anchor2_local);
  return -(skew(p1) * inverse_inertia(body1) + skew(p2) * inverse_inertia(body2));
