// expects: Units: in t1, t2, taking m^2/s^2 from m/s
  const vec3 t1 = normalize(sliding - dot(n, sliding) * sliding);
  return {t1, cross(n, t1)};
