// region: 3
// expects: Likely mistake: h and T are exchanged
  return 1 - std::exp2(-half_time / h);
