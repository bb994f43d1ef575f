// expects: Likely mistake: made a unit vector first
  if (length(sliding - dot(n, sliding) * n) < real(1e-4)) {
    const vec3 t1 = normalize(cross(n, std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0)));
    return {t1, cross(n, t1)};
  }
  const vec3 s = normalize(sliding), t1 = s - dot(n, s) * n;
  return {t1, cross(n, t1)};
