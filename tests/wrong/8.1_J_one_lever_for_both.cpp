// region: 2
// expects: Likely mistake: the lever of body 1 for both bodies
  const vec3 p = point(body1, body2), r1 = p - body1.x;
  return {-direction, -cross(r1, direction), direction, cross(r1, direction)};
