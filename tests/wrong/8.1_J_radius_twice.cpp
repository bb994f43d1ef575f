// region: 2
// expects: Likely mistake: the radius is taken away twice
  const vec3 p = point(body1, body2) - radius * up(body1);
  const vec3 r1 = p - body1.x, r2 = p - body2.x;
  return {-direction, -cross(r1, direction), direction, cross(r2, direction)};
