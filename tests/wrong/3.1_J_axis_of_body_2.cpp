// region: 2
// expects: Likely mistake: a2 in the place of a1: b x a1, not b x a2
// expects: Fails at broken; holds at upright, turned and moved.
// expects: Likely mistake: a2 in the place of a1: b x a1, not b x a2 (broken)
  Jacobian<2> J;
  J[0] = {vec3(0), c, vec3(0), -c};
  J[1] = {vec3(0), -b, vec3(0), b};
  return J;
