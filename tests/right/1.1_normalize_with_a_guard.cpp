// normalize of the zero vector is NaN: the guard keeps the row zero there.
  const vec3 u = body2.x - body1.x;
  const vec3 n = dot(u, u) > 0 ? normalize(u) : vec3(0);
  return {-n, vec3(0), n, vec3(0)};
