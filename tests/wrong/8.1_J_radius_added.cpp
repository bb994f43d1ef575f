// region: 2
// expects: Likely mistake: the sign of the radius
  const vec3 p = world_point(body2, corner_local) + radius * up(body1);
  const vec3 r1 = p - body1.x, r2 = p - body2.x;
  return {-direction, -cross(r1, direction), direction, cross(r2, direction)};
