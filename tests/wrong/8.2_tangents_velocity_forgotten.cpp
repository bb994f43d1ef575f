// expects: Likely mistake: the velocity is not looked at
  const vec3 other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0);
  const vec3 t1 = normalize(other - dot(n, other) * n);
  return {t1, cross(n, t1)};
