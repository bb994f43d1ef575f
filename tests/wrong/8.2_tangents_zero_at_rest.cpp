// expects: Likely mistake: a zero vector: friction needs two directions at rest, too
  const vec3 across = sliding - dot(n, sliding) * n;
  if (length(across) < real(1e-4)) return {vec3(0), vec3(0)};
  const vec3 t1 = normalize(across);
  return {t1, cross(n, t1)};
