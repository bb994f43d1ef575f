// expects: s alone changes its sign
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), std::abs(q.w));
