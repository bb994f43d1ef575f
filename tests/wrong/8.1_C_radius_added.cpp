// expects: Likely mistake: the radius is added
  return dot(up(body1), world_point(body2, corner_local) - body1.x) + radius - height;
