// expects: Likely mistake: height along the y axis of the world
  const vec3 top = body1.x + vec3(0, height, 0);
  return dot(up(body1), point(body1, body2) - top);
