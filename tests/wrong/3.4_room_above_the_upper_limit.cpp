// expects: Likely mistake: C at the upper limit: the room left is upper - x, not x - upper
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, -1};
  LimitRow nearer = lower.C + h * rate < upper.C - h * rate ? lower : upper;
  nearer.live = nearer.C < h * std::abs(rate) + real(0.1) * h;
  if (nearer.sign < 0) nearer.C = x - range.upper;
  return nearer;
