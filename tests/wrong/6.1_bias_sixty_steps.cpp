// expects: b, C -0.02 beta 0.15 h 1/100
// expects: Likely mistake: 60 in the place of 1/h
  return beta * C * 60;
