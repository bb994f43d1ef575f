// region: 2
// expects: Likely mistake: a lock turns and does not push: E belongs to w1 and w2, not to v1 and v2
// expects: (upright, turned, moved)
  return jacobian_from_blocks(mat3(-1), mat3(0), mat3(1), mat3(0));
