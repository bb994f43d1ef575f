// expects: Likely mistake: the speed is missing in the rule: C < h |rate| + 0.1 h
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, -1};
  LimitRow nearer = lower.C + h * rate < upper.C - h * rate ? lower : upper;
  nearer.live = range.lower == range.upper || nearer.C < real(0.1) * h;
  return nearer;
