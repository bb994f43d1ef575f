// region: 2
// expects: Likely mistake: the direction is turned once more: it is given in the world
  const vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x;
  const vec3 d = to_local(body1, direction);
  return {-d, -cross(r1, d), d, cross(r2, d)};
