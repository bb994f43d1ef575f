// region: 2
// expects: Likely mistake: n in the place of the direction
// expects: along() is asked for other directions, too
  const vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x;
  const vec3 n = up(body1);
  return {-n, -cross(r1, n), n, cross(r2, n)};
