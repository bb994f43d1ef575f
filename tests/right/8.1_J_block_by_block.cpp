// The levers from the turned corner, one block after the other.
// region: 2
  Row J;
  const vec3 r2 = to_world(body2, corner_local) - radius * up(body1);
  J.v2 = direction;
  J.v1 = -J.v2;
  J.w2 = cross(r2, direction);
  J.w1 = cross(body1.x - body2.x - r2, direction);
  return J;
