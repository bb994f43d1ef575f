// expects: Likely mistake: start is forgotten
  quat q = conjugate(body1.q) * body2.q;
  if (q.w < 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);
