// expects: Likely mistake: the turn as the world sees it, and its whole angle: take q1^-1 q2, and
// expects: only p
  const quat q = body2.q * conjugate(body1.q) * conjugate(start);
  return 2 * std::atan2(length(vec3(q.x, q.y, q.z)), q.w);
