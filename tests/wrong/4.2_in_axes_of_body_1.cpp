// expects: Likely mistake: in the axes of body 1: C is in the world, q2 start^-1 q1^-1
// expects: Likely mistake: it is in the axes of a body: C is in the world, q2 start^-1 q1^-1
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  return real(2) * vec3(q.x, q.y, q.z);
