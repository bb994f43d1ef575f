// expects: Likely mistake: q + h/2 (0, w) q is only the first term of the exponential
  const vec3 v = h / 2 * w;
  return normalize(q + quat(0, v.x, v.y, v.z) * q);
