// The relative turn in world axes, with the axis in world axes.
  quat q = body2.q * conjugate(start) * conjugate(body1.q);
  if (q.w < 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), to_world(body1, a1_local)), q.w);
