// expects: Likely mistake: the sign: b has the sign of C.
  return -beta * C / h;
