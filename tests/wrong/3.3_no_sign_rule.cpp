// expects: Likely mistake: no sign rule: q and -q are the same turn. Where s < 0 turn all of q
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);
