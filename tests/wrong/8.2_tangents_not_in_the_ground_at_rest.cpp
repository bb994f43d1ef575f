// expects: Likely mistake: t1 does not lie in the ground
  vec3 across = sliding - dot(n, sliding) * n;
  if (length(across) < real(1e-4))
    across = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0);
  const vec3 t1 = normalize(across);
  return {t1, cross(n, t1)};
