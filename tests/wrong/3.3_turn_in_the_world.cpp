// expects: Likely mistake: the turn as the world sees it (q2 q1^-1): it changes when both bodies
// expects: turn as one. q1^-1 q2 is body 2 as body 1 sees it
  quat q = body2.q * conjugate(body1.q) * conjugate(start);
  if (q.w < 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);
