// expects: Likely mistake: the sign at the upper limit: C = upper - x shrinks while x grows, so
// expects: that dC/dx is -1
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, 1};
  LimitRow nearer = lower.C + h * rate < upper.C - h * rate ? lower : upper;
  nearer.live = nearer.C < h * std::abs(rate) + real(0.1) * h;
  return nearer;
