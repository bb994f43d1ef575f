// expects: Likely mistake: the factor 2 is forgotten: v is only half the turn
  const quat q = body2.q * conjugate(start) * conjugate(body1.q);
  return (q.w < 0 ? real(-1) : real(1)) * vec3(q.x, q.y, q.z);
