// expects: J[0] is written twice
// region: 2
  Jacobian<2> J;
  J[0] = {vec3(0), -cross(b, a1), vec3(0), cross(b, a1)};
  J[0] = {vec3(0), -cross(c, a1), vec3(0), cross(c, a1)};
  return J;
