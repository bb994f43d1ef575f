// expects: and no sign rule
  const quat q = body2.q * conjugate(body1.q) * conjugate(start);
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);
