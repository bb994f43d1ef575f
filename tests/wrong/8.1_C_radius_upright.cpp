// expects: Likely mistake: the radius along the y axis of the world
  const vec3 lowest = world_point(body2, corner_local) - vec3(0, radius, 0);
  return dot(up(body1), lowest - body1.x) - height;
