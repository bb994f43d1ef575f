// region: 3
// expects: beta, T 0.1 s, h 1/60 s
// expects: Likely mistake: e in the place of 2
  return 1 - std::exp(-h / half_time);
