// expects: Likely mistake: a zero vector has no direction
// expects: t1 or t2 is not a number (at rest, n = x)
  const vec3 t1 = normalize(sliding - dot(n, sliding) * n);
  return {t1, cross(n, t1)};
