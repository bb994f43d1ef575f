// expects: Likely mistake: height is added
  return dot(up(body1), point(body1, body2) - body1.x) + height;
