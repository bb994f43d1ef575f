// expects: Likely mistake: height is forgotten
// expects: C, by hand 0.600000 0.100000 0.500000
  return dot(up(body1), point(body1, body2) - body1.x);
