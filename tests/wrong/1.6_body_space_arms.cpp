// expects: Likely mistake: body-space arm
  const vec3 n = direction(body2.x + anchor2_local - body1.x - anchor1_local);
  return {-n, -cross(anchor1_local, n), n, cross(anchor2_local, n)};
