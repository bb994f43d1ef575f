// expects: Units: the bias is in m and should be in m/s: a time too many: is a division by h missing?
  return beta * C;
