// region: 2
// expects: Likely mistake: the sign of the whole row, or bodies 1 and 2 swapped (upright, turned,
// expects: moved)
  return jacobian_from_blocks(mat3(0), mat3(1), mat3(0), mat3(-1));
