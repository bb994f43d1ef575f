// region: 2
// expects: Likely mistake: height is taken from r1
  const vec3 p = point(body1, body2), r1 = p - body1.x - height * up(body1), r2 = p - body2.x;
  return {-direction, -cross(r1, direction), direction, cross(r2, direction)};
