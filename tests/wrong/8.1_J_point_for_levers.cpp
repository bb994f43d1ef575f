// region: 2
// expects: Likely mistake: a point where a lever belongs: p - x1 and p - x2, not p itself
  const vec3 p = point(body1, body2);
  return {-direction, -cross(p, direction), direction, cross(p, direction)};
