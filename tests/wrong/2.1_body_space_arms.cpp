// expects: Likely mistake: body-space arm: the lever of body 2 is not turned into the world
// expects: Likely mistake: body-space arm: the levers of both bodies are not turned into the world (upright, turned, moved, broken)
  return jacobian_from_blocks(mat3(-1), skew(anchor1_local), mat3(1), -skew(anchor2_local));
