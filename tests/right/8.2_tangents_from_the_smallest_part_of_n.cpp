// At rest: the axis that is farthest from n.
  const auto in_the_ground = [&](const vec3& a) { return a - dot(n, a) * n; };
  vec3 across = in_the_ground(sliding);
  if (dot(across, across) < real(1e-8)) {
    int least = 0;
    for (int k = 1; k < 3; ++k)
      if (std::abs(n[k]) < std::abs(n[least])) least = k;
    vec3 axis(0);
    axis[least] = 1;
    across = in_the_ground(axis);
  }
  across /= length(across);
  return {across, cross(n, across)};
