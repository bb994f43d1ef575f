// expects: Likely mistake: only what is along n is kept: that is what has to go
  vec3 across = dot(n, sliding) * n;
  if (length(across) < real(1e-4)) {
    const vec3 other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0);
    across = other - dot(n, other) * n;
  }
  const vec3 t1 = normalize(across);
  return {t1, cross(n, t1)};
