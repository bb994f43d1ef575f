// region: 2
// expects: Likely mistake: n is turned with body 2 here, but n rides on body 1 (upright, turned,
// expects: moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  Jacobian<2> J;
  for (int i = 0; i < 2; ++i) {
    const vec3 m = to_world(body2, i == 0 ? n1_local : n2_local);
    J[i] = {-m, -cross(r1 + u, m), m, cross(r2, m)};
  }
  return J;
