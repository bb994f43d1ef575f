// expects: Likely mistake: t1 is not a unit vector
  vec3 across = sliding - dot(n, sliding) * n;
  if (length(across) < real(1e-4)) {
    const vec3 other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0);
    across = other - dot(n, other) * n;
  }
  return {across, cross(n, across)};
