// At rest: n with two of its parts exchanged, which is never along n.
  const vec3 across = sliding - dot(n, sliding) * n;
  const vec3 aside = std::abs(n.x) > std::abs(n.z) ? vec3(-n.y, n.x, 0) : vec3(0, -n.z, n.y);
  const vec3 t1 = normalize(length(across) < real(1e-4) ? aside : across);
  return {t1, cross(n, t1)};
