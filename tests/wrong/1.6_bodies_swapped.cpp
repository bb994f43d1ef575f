// expects: Likely mistake: bodies 1 and 2 swapped (upright, turned, moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  return {n, cross(r2, n), -n, -cross(r1, n)};
