// region: 2
// expects: Likely mistake: u is forgotten, the lever of body 1 is r1 + u, because a rides on body 1
// expects: (turned, moved, broken)
  const vec3 a = to_world(body1, a1_local);
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  return {-a, -cross(r1, a), a, cross(r2, a)};
