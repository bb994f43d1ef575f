// region: 2
// expects: b, C 0.02 beta 0.15 h 1/60
// expects: Likely mistake: a limit that lies ahead needs no beta: C/h just reaches it
  return beta * C / h;
