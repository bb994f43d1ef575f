// region: 2
// expects: Likely mistake: n is left in body space: turn it into the world with body 1 (turned,
// expects: moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  Jacobian<2> J;
  for (int i = 0; i < 2; ++i) {
    const vec3 m = i == 0 ? n1_local : n2_local;
    J[i] = {-m, -cross(r1 + u, m), m, cross(r2, m)};
  }
  return J;
