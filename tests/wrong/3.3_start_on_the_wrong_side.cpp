// expects: Likely mistake: start^-1 stands on the wrong side: q1^-1 q2 start^-1
  quat q = conjugate(start) * conjugate(body1.q) * body2.q;
  if (q.w < 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);
