// expects: Likely mistake: the vector that stands in for the sliding is not made a unit vector
  const vec3 across = sliding - dot(n, sliding) * n;
  if (length(across) < real(1e-4)) {
    const vec3 t1 = cross(n, std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0));
    return {t1, cross(n, t1)};
  }
  const vec3 t1 = normalize(across);
  return {t1, cross(n, t1)};
