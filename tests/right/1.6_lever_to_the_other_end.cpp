// r1 + u in the place of r1: the difference u x n is zero, since n lies along u.
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 u = body2.x + r2 - body1.x - r1, n = direction(u);
  return {-n, -cross(r1 + u, n), n, cross(r2, n)};
