// expects: b, C 0.02 beta 0.15 h 1/60
// expects: Likely mistake: h is forgotten: beta C is the way that a step shall take back
  return beta * C;
