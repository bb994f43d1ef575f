// expects: Likely mistake: body-space arm: the lever of body 2 is not turned into the world
// expects: (upright, turned, moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  return {-n, -cross(r1, n), n, cross(anchor2_local, n)};
