// The orientation that body 2 should have first, then the turn from there to where it is.
  const quat wanted = body1.q * start;
  const quat q = body2.q * inverse(wanted);
  return (q.w >= 0 ? real(2) : real(-2)) * vec3(q.x, q.y, q.z);
