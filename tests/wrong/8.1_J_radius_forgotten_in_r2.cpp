// region: 2
// expects: Likely mistake: the radius is forgotten in r2
  const vec3 r1 = point(body1, body2) - body1.x, r2 = to_world(body2, corner_local);
  return {-direction, -cross(r1, direction), direction, cross(r2, direction)};
