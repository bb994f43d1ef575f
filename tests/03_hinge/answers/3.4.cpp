// Known answers of exercise 3.4, each put in the place of the solution's.

// ---- wrong: 0.01 h
// expects: Likely mistake: less than 0.1 h is added (0.01 h, or h twice): C < h |rate| + 0.1 h
// change: 0.1 ==> 0.01

// ---- wrong: 0.1 within the absolute value
// expects: Likely mistake: the 0.1 stands outside the absolute value: |rate| + 0.1, not |rate +
// expects: 0.1|
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, -1};
  LimitRow nearer = lower.C + h * rate < upper.C - h * rate ? lower : upper;
  nearer.live = nearer.C < h * std::abs(rate + real(0.1));
  return nearer;

// ---- wrong: 1/10 in whole numbers
// expects: Likely mistake: 0.1 h is missing in the rule: C < h |rate| + 0.1 h
// change: real(0.1) ==> 1 / 10

// ---- wrong: C clamped to 0
// expects: Likely mistake: beyond the limit C is negative: it does not end at 0
  LimitRow lower{std::max(x - range.lower, real(0)), 1};
  LimitRow upper{std::max(range.upper - x, real(0)), -1};
  LimitRow nearer = lower.C + h * rate < upper.C - h * rate ? lower : upper;
  nearer.live = nearer.C < h * std::abs(rate) + real(0.1) * h;
  return nearer;

// ---- wrong: C over h
// expects: Likely mistake: C is a gap: it is not divided by h
  LimitRow lower{(x - range.lower) / h, 1}, upper{(range.upper - x) / h, -1};
  LimitRow nearer = lower.C + rate < upper.C - rate ? lower : upper;
  nearer.live = nearer.C < std::abs(rate) + real(0.1);
  return nearer;

// ---- wrong: abs of C
// expects: Likely mistake: in C alone: beyond the limit C is negative: no absolute value
  LimitRow lower{std::abs(x - range.lower), 1}, upper{std::abs(range.upper - x), -1};
  LimitRow nearer = lower.C + h * rate < upper.C - h * rate ? lower : upper;
  nearer.live = nearer.C < h * std::abs(rate) + real(0.1) * h;
  return nearer;

// ---- wrong: abs of C in the choice
// expects: Likely mistake: no absolute value in the choice: beyond a limit the gap is negative,
// expects: that is less
// change: lower.C + h * rate < upper.C - h * rate ==>
//         std::abs(lower.C + h * rate) < std::abs(upper.C - h * rate)

// ---- wrong: abs of C in the rule
// expects: Likely mistake: beyond the limit a row is live, too: C is negative there, and no
// expects: absolute value is taken
// change: nearer.C ==> std::abs(nearer.C)

// ---- wrong: abs of int rate
// expects: Likely mistake: the rate is cut off to a whole number: an int has no fraction
// change: (rate) ==> (int(rate))

// ---- wrong: both + h rate
// expects: Likely mistake: the limit with the smaller gap now: the smaller gap at the end of the
// expects: step decides, where the lower gap has grown by h rate and the upper one has shrunk by it
// change: - h ==> + h

// ---- wrong: equal limits live excluded
// expects: Likely mistake: two equal limits hold x: their row is live, too
// change: = nearer ==> = range.lower != range.upper && nearer

// ---- wrong: filled in where live
// expects: Likely mistake: C and sign are those of the nearer limit whether it is live or not
  LimitRow row;
  if (x - range.lower < h * std::abs(rate) + real(0.1) * h) row = {x - range.lower, 1, true};
  if (range.upper - x < h * std::abs(rate) + real(0.1) * h) row = {range.upper - x, -1, true};
  return row;

// ---- wrong: first live one wins
// expects: Likely mistake: the lower limit wherever it is live: the smaller gap at the end of the
// expects: step decides
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, -1};
  lower.live = lower.C < h * std::abs(rate) + real(0.1) * h;
  upper.live = upper.C < h * std::abs(rate) + real(0.1) * h;
  return lower.live ? lower : upper;

// ---- wrong: greater
// expects: Likely mistake: the rule the wrong way round: live where C is small
// change: < h ==> > h

// ---- wrong: h for 0.1 h
// expects: Likely mistake: 0.1, or h, where 0.1 h belongs
// change: real(0.1) * ==>

// ---- wrong: h of 1/60
// expects: Likely mistake: h is what is given, not 1/60
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, -1};
  LimitRow nearer = lower.C + rate / 60 < upper.C - rate / 60 ? lower : upper;
  nearer.live = nearer.C < std::abs(rate) / 60 + real(0.1) / 60;
  return nearer;

// ---- wrong: h squared
// expects: Likely mistake: less than 0.1 h is added (0.01 h, or h twice): C < h |rate| + 0.1 h
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, -1};
  LimitRow nearer = lower.C + h * rate < upper.C - h * rate ? lower : upper;
  nearer.live = nearer.C < h * (std::abs(rate) + real(0.1) * h);
  return nearer;

// ---- wrong: if lower passed else upper
// expects: Likely mistake: C and sign are those of the nearer limit whether it is passed or not
  LimitRow row;
  if (x < range.lower) row = {x - range.lower, 1, true};
  else if (x > range.upper) row = {range.upper - x, -1, true};
  return row;

// ---- wrong: int C
// expects: Likely mistake: the gaps are cut off to whole numbers: an int has no fraction
  const int below = x - range.lower, above = range.upper - x;
  LimitRow lower{real(below), 1}, upper{real(above), -1};
  LimitRow nearer = lower.C + h * rate < upper.C - h * rate ? lower : upper;
  nearer.live = nearer.C < h * std::abs(rate) + real(0.1) * h;
  return nearer;

// ---- wrong: live by gap after
// expects: Likely mistake: the gap now decides whether the row is live: C, not C + h dC/dt
// change: nearer.live = nearer.C ==>
//         const real gap = std::min(lower.C + h * rate, upper.C - h * rate); nearer.live = gap

// ---- wrong: live if either is near
// expects: Likely mistake: live is asked of the limit that is returned, not of the other one
// change: LimitRow nearer ==>
//         const real reach = h * std::abs(rate) + real(0.1) * h; const bool live = lower.C < reach
//         || upper.C < reach; LimitRow nearer
// change: nearer.C < h * std::abs(rate) + real(0.1) * h ==> live

// ---- wrong: live of lower only
// expects: Likely mistake: live is set for the lower limit alone
// change: LimitRow nearer ==>
//         lower.live = lower.C < h * std::abs(rate) + real(0.1) * h; LimitRow nearer
// change: nearer.live = nearer.C < h * std::abs(rate) + real(0.1) * h; ==>

// ---- wrong: live only in the direction
// expects: Likely mistake: live while x moves away, too: a neighbour may turn it round within the
// expects: step
// change: = nearer ==> = nearer.sign * rate <= 0 && nearer

// ---- wrong: lower C negated
// expects: Likely mistake: C at the lower limit: the gap is x - lower, not lower - x
// change: x - range.lower ==> range.lower - x

// ---- wrong: min C with sign of the choice
// expects: Likely mistake: in C and live alone: the limit with the smaller gap now: the smaller gap
// expects: at the end of the step decides, where the lower gap has grown by h rate and the upper
// expects: one has shrunk by it
// change: upper; ==> upper; nearer.C = std::min(lower.C, upper.C);

// ---- wrong: min lower upper
// expects: Likely mistake: in sign alone: the sign at the upper limit: C = upper - x shrinks while
// expects: x grows, so that dC/dx is -1
// change: lower.C + h * rate < upper.C - h * rate ? lower : upper ==>
//         lower; nearer.C = std::min(lower.C, upper.C)

// ---- wrong: min of the limits
// expects: Likely mistake: the upper limit is never looked at
  const real nearest = std::min(range.lower, range.upper);
  LimitRow row{x - nearest, 1};
  row.live = row.C < h * std::abs(rate) + real(0.1) * h;
  return row;

// ---- wrong: minus 0.1 h
// expects: Likely mistake: 0.1 h is added: C < h |rate| + 0.1 h
// change: + real ==> - real

// ---- wrong: nearer limit now
// expects: Likely mistake: the limit with the smaller gap now: the smaller gap at the end of the
// expects: step decides
// change: + h * rate < upper.C - h * rate ==> < upper.C

// ---- wrong: not live at rest
// expects: Likely mistake: a limit is live at rest, too: no rate is asked for
// change: = nearer ==> = rate != 0 && nearer

// ---- wrong: not live set
// expects: Likely mistake: live is never set
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, -1};
  return lower.C + h * rate < upper.C - h * rate ? lower : upper;

// ---- wrong: only the direction of the rate
// expects: Likely mistake: the limit toward which x moves: the smaller gap at the end of the
// expects: step decides
  LimitRow row = rate > 0 ? LimitRow{range.upper - x, -1} : LimitRow{x - range.lower, 1};
  row.live = row.C < h * std::abs(rate) + real(0.1) * h;
  return row;

// ---- wrong: only where it is passed
// expects: Likely mistake: live only where the limit is passed already: then it is too late. The
// expects: row must be there in the step before
// change: nearer.C < h * std::abs(rate) + real(0.1) * h ==>
//         range.lower == range.upper || nearer.C < 0

// ---- wrong: rate on one side
// expects: Likely mistake: the rate counts for both limits: the one gap grows by h rate, the other
// expects: shrinks by it
// change: - h * rate ==>

// ---- wrong: rate truncated to int
// expects: Likely mistake: the rate is cut off to a whole number: an int has no fraction
  const int r = rate;
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, -1};
  LimitRow nearer = lower.C + h * r < upper.C - h * r ? lower : upper;
  nearer.live = nearer.C < h * std::abs(r) + real(0.1) * h;
  return nearer;

// ---- wrong: rate without h in choice
// expects: Likely mistake: h is missing in the choice of the limit: C + h dC/dt
// change: h * ==>
// change: h * ==>

// ---- wrong: gap above the upper limit
// expects: Likely mistake: C at the upper limit: the gap is upper - x, not x - upper
// change: return nearer ==> if (nearer.sign < 0) nearer.C = x - range.upper; return nearer

// ---- wrong: gap at the end
// expects: C is the gap now
  LimitRow lower{x - range.lower + h * rate, 1}, upper{range.upper - x - h * rate, -1};
  LimitRow nearer = lower.C < upper.C ? lower : upper;
  nearer.live = nearer.C < h * std::abs(rate) + real(0.1) * h;
  return nearer;

// ---- wrong: rule with + h rate
// expects: Likely mistake: the size of the rate counts, |rate|: a neighbour may turn x round within
// expects: the step
// change: < h * std::abs(rate) + ==> + h * rate <

// ---- wrong: rule with h rate
// expects: Likely mistake: the size of the rate counts, |rate|: a neighbour may turn x round within
// expects: the step
// change: std::abs(rate) ==> rate

// ---- wrong: sign at the upper limit
// expects: Likely mistake: the sign at the upper limit: C = upper - x shrinks while x grows, so
// expects: that dC/dx is -1
// change: -1 ==> 1

// ---- wrong: sign by the rate
// expects: Likely mistake: the sign is that of the limit: it does not ask where x is going
// change: upper; ==> upper; nearer.sign = rate < 0 ? 1 : -1;

// ---- wrong: sign from C
// expects: Likely mistake: the sign is that of the limit: it does not ask whether it is passed
// change: upper; ==> upper; nearer.sign = nearer.C < 0 ? -1 : 1;

// ---- wrong: signs of rate exchanged
// expects: Likely mistake: the sign of the rate: at the end of the step x is x + h rate
// change: + h ==> - h
// change: upper.C - ==> upper.C +

// ---- wrong: unset sign
// expects: Likely mistake: a value that was never set
  LimitRow row;
  real sign, gap;
  if (x - range.lower + h * rate < range.upper - x - h * rate) { gap = x - range.lower; sign = 1; }
  else gap = range.upper - x;
  row = {gap, sign};
  row.live = row.C < h * std::abs(rate) + real(0.1) * h;
  return row;

// ---- wrong: without the speed
// expects: Likely mistake: the speed is missing in the rule: C < h |rate| + 0.1 h
// change: nearer.C < h * std::abs(rate) + ==> range.lower == range.upper || nearer.C <

// ---- right: compared with both limits at once
  const bool lower = 2 * (x + h * rate) < range.lower + range.upper;
  LimitRow row;
  row.C = lower ? x - range.lower : range.upper - x;
  row.sign = lower ? 1 : -1;
  row.live = row.C <= h * (std::abs(rate) + real(0.1));
  return row;

// ---- right: less or equal
// change: < upper ==> <= upper
// change: < h ==> <= h

// ---- right: where x will be
// The middle between the limits decides, with x as it will be.
  const real next = x + h * rate;
  LimitRow row{x - range.lower, 1};
  if (range.upper - next < next - range.lower) row = {range.upper - x, -1};
  row.live = row.C - h * std::abs(rate) < real(0.1) * h || range.lower == range.upper;
  return row;

// ---- right: with std::min_element
  return [&] {
    LimitRow both[2] = {{x - range.lower, 1}, {range.upper - x, -1}};
    for (LimitRow& row : both) row.live = row.C < h * (std::fabs(rate) + real(0.1));
    return *std::min_element(both, both + 2, [&](const LimitRow& a, const LimitRow& b) {
      return a.C + h * a.sign * rate < b.C + h * b.sign * rate;
    });
  }();

// ---- wrong units: rate for displacement
// expects: Units: in limit_row (rates as pure numbers and x in s), adding a pure number to s: h
// expects: is missing
// change: lower.C + h * rate < upper.C - h * rate ? lower : upper ==>
//         upper.C - rate < lower.C + rate ? upper : lower
// change: = nearer ==> = range.lower == range.upper || nearer
