// expects: Likely mistake: what slides slowly counts as nothing
// expects: Or is a squared length compared with it?
  vec3 across = sliding - dot(n, sliding) * n;
  if (dot(across, across) < real(1e-4)) {
    const vec3 other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0);
    across = other - dot(n, other) * n;
  }
  const vec3 t1 = normalize(across);
  return {t1, cross(n, t1)};
