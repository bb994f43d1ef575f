// expects: Fails at turned, moved and broken; holds at upright.
// expects: Likely mistake: body-space arm: the lever of body 1 is not turned into the world
// expects: (turned, moved, broken)
  const vec3 r1 = anchor1_local, r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  return {-n, -cross(r1, n), n, cross(r2, n)};
