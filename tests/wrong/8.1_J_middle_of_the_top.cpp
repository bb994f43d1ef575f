// region: 2
// expects: Likely mistake: r1 ends in the middle of the top
  const vec3 r1 = height * up(body1), r2 = point(body1, body2) - body2.x;
  return {-direction, -cross(r1, direction), direction, cross(r2, direction)};
