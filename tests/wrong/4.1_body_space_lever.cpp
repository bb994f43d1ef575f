// region: 2
// expects: Likely mistake: body-space arm: the lever of body 1 is not turned into the world
// expects: (turned, moved, broken)
  const vec3 r1 = anchor1_local, r2 = to_world(body2, anchor2_local);
  Jacobian<2> J;
  for (int i = 0; i < 2; ++i) J[i] = {-n[i], -cross(r1 + u, n[i]), n[i], cross(r2, n[i])};
  return J;
