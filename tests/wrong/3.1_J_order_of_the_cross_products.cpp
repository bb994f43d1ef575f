// region: 2
// expects: Likely mistake: the sign: b x a1, not a1 x b. Or the signs of the bodies exchanged
// expects: Likely mistake: the sign of the whole row, or bodies 1 and 2 swapped (upright, turned,
// expects: moved, broken)
  Jacobian<2> J;
  J[0] = {vec3(0), -cross(a1, b), vec3(0), cross(a1, b)};
  J[1] = {vec3(0), -cross(a1, c), vec3(0), cross(a1, c)};
  return J;
