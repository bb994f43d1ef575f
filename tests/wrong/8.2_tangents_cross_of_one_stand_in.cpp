// expects: Likely mistake: the vector that stands in for the sliding is along n here
// expects: n along the vector that stands in
  vec3 across = sliding - dot(n, sliding) * n;
  const vec3 other(real(0.3), real(-0.7), real(0.2));
  if (length(across) < real(1e-4)) across = cross(n, other);
  const vec3 t1 = normalize(across);
  return {t1, cross(n, t1)};
