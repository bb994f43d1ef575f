// The turn in the axes of body 1; its vector is turned into the world.
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  const real sign = std::copysign(real(2), q.w);
  return to_world(body1, sign * vec3(q.x, q.y, q.z));
