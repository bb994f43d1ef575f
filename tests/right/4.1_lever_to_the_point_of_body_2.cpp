// region: 2
// r1 + u is the arrow from the centre of body 1 to the point of body 2.
  const vec3 p2 = world_point(body2, anchor2_local);
  return {{Row{-n[0], cross(n[0], p2 - body1.x), n[0], cross(p2 - body2.x, n[0])},
           Row{-n[1], cross(n[1], p2 - body1.x), n[1], cross(p2 - body2.x, n[1])}}};
