// expects: Likely mistake: the limit with less room now: the one with less room at the end of the
// expects: step counts
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, -1};
  LimitRow nearer = lower.C < upper.C ? lower : upper;
  nearer.live = nearer.C < h * std::abs(rate) + real(0.1) * h;
  return nearer;
