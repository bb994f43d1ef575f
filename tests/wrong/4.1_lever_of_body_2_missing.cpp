// region: 2
// expects: Likely mistake: the block w2 is missing (upright, turned, moved, broken)
// expects: Likely mistake: the lever of body 2 is missing
  const vec3 r1 = to_world(body1, anchor1_local);
  Jacobian<2> J;
  for (int i = 0; i < 2; ++i) J[i] = {-n[i], -cross(r1 + u, n[i]), n[i], vec3(0)};
  return J;
