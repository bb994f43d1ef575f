// region: 2
// expects: Likely mistake: levers are missing: such a row drives the centres, not the points
// expects: (upright, turned, moved, broken)
// expects: Likely mistake: the levers are missing: push and answer act along two lines, and that
// expects: turns the pair
  const vec3 a = to_world(body1, a1_local);
  return {-a, vec3(0), a, vec3(0)};
