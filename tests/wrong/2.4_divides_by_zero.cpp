// expects: q of a body at rest.w
// expects: Likely mistake: a division by zero
  const real angle = h * length(w);
  const vec3 v = std::sin(angle / 2) * w / length(w);
  return normalize(quat(std::cos(angle / 2), v.x, v.y, v.z) * q);
