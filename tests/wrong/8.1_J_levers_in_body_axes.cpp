// region: 2
// expects: Likely mistake: J is in world axes
  const vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x;
  const vec3 l1 = to_local(body1, r1), l2 = to_local(body2, r2);
  return {-direction, -cross(l1, direction), direction, cross(l2, direction)};
