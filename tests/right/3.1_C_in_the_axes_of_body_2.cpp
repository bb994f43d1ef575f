// The same products in body 2's own axes: a1 goes there, b and c stay.
  const vec3 a1 = to_local(body2, to_world(body1, a1_local));
  return {dot(a1, b_local), dot(a1, c_local)};
