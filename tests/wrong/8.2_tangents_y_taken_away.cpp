// expects: Likely mistake: the y part of the velocity is taken away: n need not be the y axis
  vec3 across = sliding - vec3(0, sliding.y, 0);
  if (length(across) < real(1e-4)) {
    const vec3 other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0);
    across = other - dot(n, other) * n;
  }
  const vec3 t1 = normalize(across);
  return {t1, cross(n, t1)};
