// The twist alone, s over the length of (s, p), and the sign of p.
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  const real p = dot(vec3(q.x, q.y, q.z), a1_local);
  const real angle = 2 * std::acos(std::min(q.w / std::hypot(q.w, p), real(1)));
  return p < 0 ? -angle : angle;
