// region: 2
// expects: Likely mistake: the y axis of the world in the place of the direction
  const vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x;
  const vec3 n(0, 1, 0);
  return {-n, -cross(r1, n), n, cross(r2, n)};
