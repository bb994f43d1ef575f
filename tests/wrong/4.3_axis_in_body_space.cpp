// region: 2
// expects: Likely mistake: a is left in body space: turn it into the world with body 1 (turned,
// expects: moved, broken)
  const vec3 a = a1_local;
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  return {-a, -cross(r1 + u, a), a, cross(r2, a)};
