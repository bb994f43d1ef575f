// -q instead of q where s > 0: then both signs turn, in s and in p.
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w > 0) q = -q;
  const real p = dot(vec3(q.x, q.y, q.z), a1_local);
  return 2 * std::atan2(-p, -q.w);
