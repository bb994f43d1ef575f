// The point seen from body 1: its y is the height above the centre.
  return to_local(body1, point(body1, body2) - body1.x).y - height;
