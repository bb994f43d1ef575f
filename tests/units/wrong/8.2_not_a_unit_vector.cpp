// expects: Units: t1 is in m/s and should be a pure number
  const vec3 across = sliding - dot(n, sliding) * n;
  return {across, cross(n, across)};
