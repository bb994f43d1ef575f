// expects: Likely mistake: the lever of body 2 in the place of the one of body 1
  return dot(up(body1), point(body1, body2) - body2.x) - height;
