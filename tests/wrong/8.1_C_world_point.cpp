// expects: Likely mistake: a world point in the place of p - x1
  return dot(up(body1), point(body1, body2)) - height;
