// expects: Likely mistake: the sign of the blocks w1 and w2: a x b is -(b x a) (upright, turned,
// expects: moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  return jacobian_from_blocks(mat3(-1), transpose(skew(r1)), mat3(1), -transpose(skew(r2)));
