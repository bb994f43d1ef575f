// expects: Units: J.v1 is in m and should be a pure number: a length too many: an arm, or a
// expects: direction that is not a unit vector
  const vec3 u = body2.x - body1.x;
  return {-u, vec3(0), u, vec3(0)};
