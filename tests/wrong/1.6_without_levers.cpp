// expects: Likely mistake: the blocks w1 and w2 are missing: they hold the levers (upright,
// expects: turned, moved, broken)
  const vec3 u = world_point(body2, anchor2_local) - world_point(body1, anchor1_local);
  const vec3 n = direction(u);
  return {-n, vec3(0), n, vec3(0)};
