// expects: Likely mistake: the sign: body 2 is turned too far, so q2 stands first and q1 is inverted
  quat q = body1.q * start * conjugate(body2.q);
  if (q.w < 0) q = -q;
  return real(2) * vec3(q.x, q.y, q.z);
