// The way is the same number, seen from body 1.
  return dot(to_local(body1, u), a1_local);
