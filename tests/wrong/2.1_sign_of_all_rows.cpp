// expects: Likely mistake: the sign of the whole row: C grows when body 2 moves positively
// expects: (upright, turned, moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  return jacobian_from_blocks(mat3(1), -skew(r1), mat3(-1), skew(r2));
