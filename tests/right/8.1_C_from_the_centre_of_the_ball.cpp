// The centre of the ball has its own height, and the radius is taken from it.
  return dot(up(body1), world_point(body2, corner_local) - body1.x) - radius - height;
