// region: 2
// expects: b, C -0.02 beta 1.5 h 1/60
// expects: Likely mistake: the larger one of the two
  return std::max(beta * C / h, C / h);
