// region: 2
// expects: Likely mistake: point(body2, body1): the other way round, the corner is one of body 2
  const vec3 p = point(body2, body1), r1 = p - body1.x, r2 = p - body2.x;
  return {-direction, -cross(r1, direction), direction, cross(r2, direction)};
