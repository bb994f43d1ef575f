// expects: Likely mistake: the tangent of half the angle: it has no bound at a half turn
  const quat q = body2.q * conjugate(start) * conjugate(body1.q);
  return real(2) * vec3(q.x, q.y, q.z) / q.w;
