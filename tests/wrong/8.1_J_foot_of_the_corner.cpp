// region: 2
// expects: Likely mistake: r1 ends on the top, below the corner
// expects: Fails at pencil and paper and off the top; holds at upright, turned and moved.
  const vec3 p = point(body1, body2), r2 = p - body2.x;
  const vec3 r1 = p - error(body1, body2) * up(body1) - body1.x;
  return {-direction, -cross(r1, direction), direction, cross(r2, direction)};
