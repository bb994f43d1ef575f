// region: 2
// expects: Likely mistake: u is forgotten, the lever of body 1 is r1 + u, because n rides on body 1
// expects: (turned, moved, broken)
// expects: Likely mistake: u belongs to the lever of body 1 and to no other: push and answer act
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  Jacobian<2> J;
  for (int i = 0; i < 2; ++i) J[i] = {-n[i], -cross(r1, n[i]), n[i], cross(r2, n[i])};
  return J;
