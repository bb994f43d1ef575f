// region: 2
// expects: Likely mistake: the radius is forgotten: the levers end at point(), the
// expects: lowest point of the ball
// expects: t1, w1.x
  const vec3 p = world_point(body2, corner_local), r1 = p - body1.x, r2 = p - body2.x;
  return {-direction, -cross(r1, direction), direction, cross(r2, direction)};
