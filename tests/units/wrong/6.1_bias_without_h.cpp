// expects: Units: the bias is in m and should be in m/s: a time too many
  return beta * C;
