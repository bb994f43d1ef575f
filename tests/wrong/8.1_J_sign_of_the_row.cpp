// region: 2
// expects: Likely mistake: the sign of the whole row: J V is how fast body 2 moves along the
// expects: the sign of the whole row: C grows when body 2 moves up
  const vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x;
  return {direction, cross(r1, direction), -direction, -cross(r2, direction)};
