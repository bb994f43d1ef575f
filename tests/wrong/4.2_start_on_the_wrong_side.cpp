// expects: Likely mistake: start is on the wrong side of q1^-1: (q1 start)^-1 = start^-1 q1^-1
  quat q = body2.q * conjugate(body1.q) * conjugate(start);
  if (q.w < 0) q = -q;
  return real(2) * vec3(q.x, q.y, q.z);
