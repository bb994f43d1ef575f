// region: 2
// expects: Likely mistake: c_local is not turned into the world: take c above
// expects: Likely mistake: b_local and c_local are not turned into the world: take b and c above
// expects: (upright, turned, moved, broken)
  Jacobian<2> J;
  J[0] = {vec3(0), -cross(b_local, a1), vec3(0), cross(b_local, a1)};
  J[1] = {vec3(0), -cross(c_local, a1), vec3(0), cross(c_local, a1)};
  return J;
