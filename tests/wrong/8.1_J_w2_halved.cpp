// region: 2
// expects: Likely mistake: a factor of 0.5 in the block w2
  const vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x;
  return {-direction, -cross(r1, direction), direction, cross(r2, direction) / real(2)};
