// expects: C is the room now
  LimitRow lower{x - range.lower + h * rate, 1}, upper{range.upper - x - h * rate, -1};
  LimitRow nearer = lower.C < upper.C ? lower : upper;
  nearer.live = nearer.C < h * std::abs(rate) + real(0.1) * h;
  return nearer;
