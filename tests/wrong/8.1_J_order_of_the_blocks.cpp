// region: 2
// expects: Likely mistake: the order of the blocks: a row is {v1, w1, v2, w2}
  const vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x;
  return {-direction, direction, -cross(r1, direction), cross(r2, direction)};
