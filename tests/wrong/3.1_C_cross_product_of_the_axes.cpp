// expects: Likely mistake: the cross product of the axes: that holds a1.c and -(a1.b)
  const vec3 a1 = to_world(body1, a1_local);
  const vec3 b = to_world(body2, b_local), c = to_world(body2, c_local);
  const vec3 across = cross(a1, cross(b, c));
  return {dot(across, b), dot(across, c)};
