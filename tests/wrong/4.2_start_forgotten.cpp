// expects: C (pencil and paper), start = q2.z
// expects: Likely mistake: start is forgotten: the turn that the bodies began with is no error
  quat q = body2.q * conjugate(body1.q);
  if (q.w < 0) q = -q;
  return real(2) * vec3(q.x, q.y, q.z);
