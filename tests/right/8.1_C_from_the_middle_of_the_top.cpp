// Measured from a point of the top.
  const vec3 n = up(body1), top = body1.x + height * n;
  return dot(point(body1, body2) - top, n);
