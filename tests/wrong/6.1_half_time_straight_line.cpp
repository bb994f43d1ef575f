// region: 3
// expects: Likely mistake: a straight line, h/(2T): each step takes its share of what is LEFT
  return h / (2 * half_time);
