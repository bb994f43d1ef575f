// region: 2
// expects: b, C -0.02 beta 0.15 h 1/60
// expects: Likely mistake: the two lines are exchanged
  return C > 0 ? beta * C / h : C / h;
