// expects: Likely mistake: divided by 60: one over h is times 60
  return beta * C / 60;
