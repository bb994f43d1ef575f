// expects: Likely mistake: the radius is forgotten: the lowest point of the ball counts
// expects: C, ball, upright
  return dot(up(body1), world_point(body2, corner_local) - body1.x) - height;
