// expects: Likely mistake: n is the axis of body 2
  return dot(up(body2), point(body1, body2) - body1.x) - height;
