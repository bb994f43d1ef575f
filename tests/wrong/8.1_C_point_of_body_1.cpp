// expects: Likely mistake: point(body2, body1): the other way round, the corner is one of body 2
  return dot(up(body1), point(body2, body1) - body1.x) - height;
