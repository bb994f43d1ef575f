// expects: Likely mistake: the sign of the whole row, or bodies 1 and 2 swapped (upright, turned,
// expects: moved, broken)
  const vec3 n = direction(body1.x - body2.x);
  return {-n, vec3(0), n, vec3(0)};
