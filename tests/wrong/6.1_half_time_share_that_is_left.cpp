// region: 3
// expects: Likely mistake: this is the share that a step leaves, beta is the one that it takes
  return std::exp2(-h / half_time);
