// GLM makes the same quaternion of an angle and an axis.
  const real speed = length(w);
  if (speed == 0) return q;
  return normalize(glm::angleAxis(h * speed, w / speed) * q);
