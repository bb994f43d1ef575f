// region: 2
// Push and answer both act at the point of body 2.
  const vec3 a = to_world(body1, a1_local), p2 = world_point(body2, anchor2_local);
  return {-a, -cross(p2 - body1.x, a), a, cross(p2 - body2.x, a)};
