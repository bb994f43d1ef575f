// region: 2
// expects: Likely mistake: the sign of the blocks w1 and w2
  const vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x;
  return {-direction, -cross(direction, r1), direction, cross(direction, r2)};
