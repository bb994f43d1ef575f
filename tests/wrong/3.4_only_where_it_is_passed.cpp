// expects: Likely mistake: live only where the limit is passed already: then it is too late. The
// expects: row must be there in the step before
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, -1};
  LimitRow nearer = lower.C + h * rate < upper.C - h * rate ? lower : upper;
  nearer.live = range.lower == range.upper || nearer.C < 0;
  return nearer;
