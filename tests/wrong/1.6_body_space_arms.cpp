// expects: Likely mistake: body-space arm: the levers of both bodies are not turned into the world
// expects: (upright, turned, moved, broken)
  const vec3 r1 = anchor1_local, r2 = anchor2_local;
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  return {-n, -cross(r1, n), n, cross(r2, n)};
