// t2 first: n x sliding has no part along n.
  vec3 side = cross(n, sliding);
  if (length(side) < real(1e-4))
    side = cross(n, std::abs(n.y) < real(0.9) ? vec3(0, 1, 0) : vec3(0, 0, 1));
  const vec3 t2 = normalize(side);
  return {cross(t2, n), t2};
