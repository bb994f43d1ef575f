// expects: Likely mistake: what slides slowly counts as nothing
// expects: slow, 0.0002 m/s
  vec3 across = sliding - dot(n, sliding) * n;
  if (length(across) < real(1e-3)) {
    const vec3 other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0);
    across = other - dot(n, other) * n;
  }
  const vec3 t1 = normalize(across);
  return {t1, cross(n, t1)};
