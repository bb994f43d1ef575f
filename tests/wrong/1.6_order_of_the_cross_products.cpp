// expects: Likely mistake: the sign of the blocks w1 and w2: a x b is -(b x a) (upright, turned,
// expects: moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  return {-n, -cross(n, r1), n, cross(n, r2)};
