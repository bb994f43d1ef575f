// expects: Likely mistake: the direction runs from centre to centre, not from anchor to anchor
// expects: (upright, turned, moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x - body1.x);
  return {-n, -cross(r1, n), n, cross(r2, n)};
