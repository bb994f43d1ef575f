// region: 2
// expects: Likely mistake: a limit that lies ahead stops the approach far from it
  return C < 0 ? beta * C / h : 0;
