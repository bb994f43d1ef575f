// expects: Likely mistake: b_local and c_local are not turned into the world
  const vec3 a1 = to_world(body1, a1_local);
  return {dot(a1, b_local), dot(a1, c_local)};
