// expects: Likely mistake: n is not turned: up is the y axis of body 1
  return (point(body1, body2) - body1.x).y - height;
