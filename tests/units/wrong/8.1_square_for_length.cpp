// expects: Units: in C, taking m from m^2: an arm is missing, or another length
  const vec3 r1 = point(body1, body2) - body1.x;
  return dot(r1, r1) - height;
