// region: 2
// expects: Likely mistake: the sign of the blocks v1 and w1: body 1 carries the minus sign
  const vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x;
  return {direction, cross(r1, direction), direction, cross(r2, direction)};
