// expects: Likely mistake: not a unit vector: take direction(...) of the difference (upright,
// expects: turned, moved, broken)
  const vec3 u = body2.x - body1.x;  // the thesis' J, meant for C = (|u|^2 - d^2)/2 (E20)
  return {-u, vec3(0), u, vec3(0)};
