// region: 2
// expects: Likely mistake: the levers r1 and r2 are exchanged
  const vec3 p = point(body1, body2), r1 = p - body2.x, r2 = p - body1.x;
  return {-direction, -cross(r1, direction), direction, cross(r2, direction)};
