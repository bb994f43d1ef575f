// -q is the same orientation as q.
  const real angle = h * length(w);
  if (angle == 0) return -q;
  const vec3 v = std::sin(angle / 2) * w / length(w);
  return -normalize(quat(std::cos(angle / 2), v.x, v.y, v.z) * q);
