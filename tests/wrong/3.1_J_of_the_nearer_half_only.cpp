// region: 2
// expects: Likely mistake: take a1 as it stands above: beyond 60 degrees it holds body 2's axis
  const vec3 axis = to_world(body1, a1_local);
  Jacobian<2> J;
  J[0] = {vec3(0), -cross(b, axis), vec3(0), cross(b, axis)};
  J[1] = {vec3(0), -cross(c, axis), vec3(0), cross(c, axis)};
  return J;
