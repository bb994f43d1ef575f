// The same two numbers, seen from body 1: u is turned and n1 and n2 stay.
  const vec3 seen = to_local(body1, u);
  return {dot(seen, n1_local), dot(seen, n2_local)};
