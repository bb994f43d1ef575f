// region: 2
// expects: Likely mistake: levers are missing: such a row drives the centres, not the points, and
// expects: its sign is wrong as well (upright, turned, moved, broken)
  const vec3 a = to_world(body1, a1_local);
  return {a, vec3(0), -a, vec3(0)};
