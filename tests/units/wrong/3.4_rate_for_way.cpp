// expects: Units: in limit_row (rates as pure numbers and x in s), adding a pure number to s: h
// expects: is missing
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, -1};
  LimitRow nearer = upper.C - rate < lower.C + rate ? upper : lower;
  nearer.live = range.lower == range.upper || nearer.C < h * std::abs(rate) + real(0.1) * h;
  return nearer;
