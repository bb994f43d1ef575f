// Known answers of exercise 3.4, each put in the place of the solution's.

// ---- wrong: nearer limit now
// expects: Likely mistake: the limit with less room now: the one with less room at the end of the
// expects: step counts
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, -1};
  LimitRow nearer = lower.C < upper.C ? lower : upper;
  nearer.live = nearer.C < h * std::abs(rate) + real(0.1) * h;
  return nearer;

// ---- wrong: only where it is passed
// expects: Likely mistake: live only where the limit is passed already: then it is too late. The
// expects: row must be there in the step before
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, -1};
  LimitRow nearer = lower.C + h * rate < upper.C - h * rate ? lower : upper;
  nearer.live = range.lower == range.upper || nearer.C < 0;
  return nearer;

// ---- wrong: room above the upper limit
// expects: Likely mistake: C at the upper limit: the room left is upper - x, not x - upper
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, -1};
  LimitRow nearer = lower.C + h * rate < upper.C - h * rate ? lower : upper;
  nearer.live = nearer.C < h * std::abs(rate) + real(0.1) * h;
  if (nearer.sign < 0) nearer.C = x - range.upper;
  return nearer;

// ---- wrong: room at the end
// expects: C is the room now
  LimitRow lower{x - range.lower + h * rate, 1}, upper{range.upper - x - h * rate, -1};
  LimitRow nearer = lower.C < upper.C ? lower : upper;
  nearer.live = nearer.C < h * std::abs(rate) + real(0.1) * h;
  return nearer;

// ---- wrong: sign at the upper limit
// expects: Likely mistake: the sign at the upper limit: C = upper - x shrinks while x grows, so
// expects: that dC/dx is -1
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, 1};
  LimitRow nearer = lower.C + h * rate < upper.C - h * rate ? lower : upper;
  nearer.live = nearer.C < h * std::abs(rate) + real(0.1) * h;
  return nearer;

// ---- wrong: without the speed
// expects: Likely mistake: the speed is missing in the rule: C < h |rate| + 0.1 h
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, -1};
  LimitRow nearer = lower.C + h * rate < upper.C - h * rate ? lower : upper;
  nearer.live = range.lower == range.upper || nearer.C < real(0.1) * h;
  return nearer;

// ---- right: where x will be
// The middle between the limits decides, with x as it will be.
  const real next = x + h * rate;
  LimitRow row{x - range.lower, 1};
  if (range.upper - next < next - range.lower) row = {range.upper - x, -1};
  row.live = row.C - h * std::abs(rate) < real(0.1) * h || range.lower == range.upper;
  return row;

// ---- wrong units: rate for way
// expects: Units: in limit_row (rates as pure numbers and x in s), adding a pure number to s: h
// expects: is missing
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, -1};
  LimitRow nearer = upper.C - rate < lower.C + rate ? upper : lower;
  nearer.live = range.lower == range.upper || nearer.C < h * std::abs(rate) + real(0.1) * h;
  return nearer;
