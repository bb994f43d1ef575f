// expects: Likely mistake: corner_local is not turned into the world
  const vec3 p = body2.x + corner_local - radius * up(body1);
  return dot(up(body1), p - body1.x) - height;
