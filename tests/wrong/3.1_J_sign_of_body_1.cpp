// region: 2
// expects: Likely mistake: the sign: body 1 carries the minus
// expects: Likely mistake: the sign of the block w1 (upright, turned, moved, broken)
  Jacobian<2> J;
  J[0] = {vec3(0), cross(b, a1), vec3(0), cross(b, a1)};
  J[1] = {vec3(0), cross(c, a1), vec3(0), cross(c, a1)};
  return J;
