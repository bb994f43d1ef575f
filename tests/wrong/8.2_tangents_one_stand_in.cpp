// expects: Likely mistake: the vector that stands in for the sliding is along n here
// expects: (at rest, n along (
  vec3 across = sliding - dot(n, sliding) * n;
  if (length(across) < real(1e-4)) across = vec3(1) - dot(n, vec3(1)) * n;
  const vec3 t1 = normalize(across);
  return {t1, cross(n, t1)};
