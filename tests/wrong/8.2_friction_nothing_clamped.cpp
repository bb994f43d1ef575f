// region: 2
// expects: Likely mistake: nothing is clamped
  (void)mu;
  (void)normal;
  sum -= rate / K;
  return -rate / K;
