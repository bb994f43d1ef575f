// expects: C (pencil and paper), -q2.z
// expects: Likely mistake: the sign rule is forgotten: where s < 0, take -q
  const quat q = body2.q * conjugate(start) * conjugate(body1.q);
  return real(2) * vec3(q.x, q.y, q.z);
