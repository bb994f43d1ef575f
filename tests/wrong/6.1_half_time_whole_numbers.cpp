// region: 3
// expects: Likely mistake: it is always 1: 1/2 of whole numbers is 0
  return 1 - std::pow(1 / 2, h / half_time);
