// expects: Likely mistake: the factor 2 is missing: a quaternion holds half the angle
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  return std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);
