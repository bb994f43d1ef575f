// region: 2
// expects: Likely mistake: corner_local is not turned into the world: point() does it
  const vec3 p = body2.x + corner_local - radius * up(body1);
  const vec3 r1 = p - body1.x, r2 = p - body2.x;
  return {-direction, -cross(r1, direction), direction, cross(r2, direction)};
