// expects: Likely mistake: the radius is taken away twice
  return dot(up(body1), point(body1, body2) - body1.x) - radius - height;
