// expects: Likely mistake: the half of the angle is forgotten
  const real angle = h * length(w);
  if (angle == 0) return q;
  const vec3 v = std::sin(angle) * w / length(w);
  return normalize(quat(std::cos(angle), v.x, v.y, v.z) * q);
