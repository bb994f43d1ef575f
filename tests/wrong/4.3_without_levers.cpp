// region: 2
// expects: Likely mistake: levers are missing: such a row drives the centres, not the points
// expects: (upright, turned, moved, broken)
// expects: Likely mistake: levers are missing, or are points: push and answer act along two lines
  const vec3 a = to_world(body1, a1_local);
  return {-a, vec3(0), a, vec3(0)};
