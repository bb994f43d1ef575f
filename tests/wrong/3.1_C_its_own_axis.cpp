// expects: Likely mistake: a2 with its own b and c is always 0: take a1, the axis of body 1
  const vec3 b = to_world(body2, b_local), c = to_world(body2, c_local);
  const vec3 a2 = cross(b, c);
  return {dot(a2, b), dot(a2, c)};
