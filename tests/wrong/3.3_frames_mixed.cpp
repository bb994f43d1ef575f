// expects: Likely mistake: the axis and the turn in different frames: in body 1's frame the axis is
// expects: a1_local as it stands
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), to_world(body1, a1_local)), q.w);
