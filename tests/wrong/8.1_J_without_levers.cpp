// region: 2
// expects: Likely mistake: the blocks w1 and w2 are missing: they hold the levers
  return {-direction, vec3(0), direction, vec3(0)};
