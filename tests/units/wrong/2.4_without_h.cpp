// expects: Units: in q, the sine of 1/s: h is missing
  const real angle = length(w);
  if (angle == 0) return q;
  const vec3 v = std::sin(angle / 2) * w / angle;
  return normalize(quat(std::cos(angle / 2), v.x, v.y, v.z) * q);
