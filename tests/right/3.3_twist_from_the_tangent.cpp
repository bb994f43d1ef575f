// p/s is the same for q and -q, and atan stays within a quarter turn: no rule of signs is needed.
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  return 2 * std::atan(dot(vec3(q.x, q.y, q.z), a1_local) / q.w);
