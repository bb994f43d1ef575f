// expects: Likely mistake: the height of the point in the world
  return point(body1, body2).y - height;
