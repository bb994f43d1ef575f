// region: 2
// expects: Likely mistake: the sign of the whole row: C grows when body 2 moves positively
  const vec3 a = to_world(body1, a1_local);
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  return {a, cross(r1 + u, a), -a, -cross(r2, a)};
