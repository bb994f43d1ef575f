// expects: Likely mistake: body-space arm: the levers of both bodies are not turned into the world
// expects: (upright, turned, moved, broken)
  return jacobian_from_blocks(mat3(-1), skew(anchor1_local), mat3(1), -skew(anchor2_local));
