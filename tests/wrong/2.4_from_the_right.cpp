// expects: Likely mistake: the turn is multiplied from the right: w is in world axes, not body axes
  const real angle = h * length(w);
  if (angle == 0) return q;
  const vec3 v = std::sin(angle / 2) * w / length(w);
  return normalize(q * quat(std::cos(angle / 2), v.x, v.y, v.z));
