// region: 2
// expects: Likely mistake: the block w1 is missing
  const vec3 p = point(body1, body2), r2 = p - body2.x;
  return {-direction, vec3(0), direction, cross(r2, direction)};
