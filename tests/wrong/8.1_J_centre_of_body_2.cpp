// region: 2
// expects: Likely mistake: r1 ends at the centre of body 2
  const vec3 r1 = body2.x - body1.x, r2 = point(body1, body2) - body2.x;
  return {-direction, -cross(r1, direction), direction, cross(r2, direction)};
