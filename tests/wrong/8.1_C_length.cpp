// expects: Likely mistake: the length of p - x1: only what is along n counts
  return length(point(body1, body2) - body1.x) - height;
