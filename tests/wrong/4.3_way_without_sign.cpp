// expects: Likely mistake: the length of u: only its part along a is the way
  return length(u);
