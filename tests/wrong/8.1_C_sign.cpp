// expects: Likely mistake: the sign: C is positive above the top
  return height - dot(up(body1), point(body1, body2) - body1.x);
