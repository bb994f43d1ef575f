// expects: Likely mistake: the sign of the block v1 (upright, turned, moved, broken)
  const vec3 n = direction(body2.x - body1.x);
  return {n, vec3(0), n, vec3(0)};
