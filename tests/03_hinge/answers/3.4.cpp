// wrong drawn-threshold: nearer.live = ==> if (std::abs(nearer.C) < real(1e-9)) nearer.C = 0;
//         nearer.live =
// wrong 0-01-h: 0.1 ==> 0.01
// wrong 0-1-within-absolute: (rate) + real(0.1) * h ==> (rate + real(0.1))
// wrong 1-10-whole-numbers: real(0.1) ==> 1 / 10
// wrong c-clamped-0: {x - range.lower, 1}, upper{range.upper - x, -1} ==> {std::max(x -
//         range.lower, real(0)), 1}; LimitRow upper{std::max(range.upper - x, real(0)), -1}
// wrong c-over-h: {x - range.lower, 1}, upper{range.upper - x, -1} ==> {(x - range.lower) / h, 1},
//         upper{(range.upper - x) / h, -1} ;; h * rate < upper.C - h * ==> rate < upper.C - ;; h *
//         ==> ;; * h ==>
// wrong abs-of-c: x - range.lower ==> std::abs(x - range.lower) ;; range.upper - x ==>
//         std::abs(range.upper - x)
// wrong abs-c-choice: lower.C + h * rate < upper.C - h * rate ==> std::abs(lower.C + h * rate) <
//         std::abs(upper.C - h * rate)
// wrong abs-c-rule: nearer.C ==> std::abs(nearer.C)
// wrong abs-int-rate: (rate) ==> (int(rate))
// wrong both-h-rate: - h ==> + h
// wrong equal-limits-live-excluded: = nearer ==> = range.lower != range.upper && nearer
// wrong filled-where-live:
  LimitRow row;
  if (x - range.lower < h * std::abs(rate) + real(0.1) * h) row = {x - range.lower, 1, true};
  if (range.upper - x < h * std::abs(rate) + real(0.1) * h) row = {range.upper - x, -1, true};
  return row;
// wrong first-live-one-wins: LimitRow nearer = lower.C + h * rate < upper.C - h * rate ? lower :
//         upper; nearer.live = nearer ==> lower.live = lower.C < h * std::abs(rate) + real(0.1) *
//         h; upper.live = upper ;; nearer ==> lower.live ? lower : upper
// wrong greater: < h ==> > h
// wrong h-0-1-h: real(0.1) * ==>
// wrong h-1-60: h * rate < upper.C - h * rate ==> rate / 60 < upper.C - rate / 60 ;; h * ==> ;; +
//         real(0.1) * h ==> / 60 + real(0.1) / 60
// wrong if-lower-passed-else:
  LimitRow row;
  if (x < range.lower) row = {x - range.lower, 1, true};
  else if (x > range.upper) row = {range.upper - x, -1, true};
  return row;
// wrong int-c: LimitRow lower{x - range.lower, 1}, upper{range.upper - x, -1} ==> const int below =
//         x - range.lower, above = range.upper - x; LimitRow lower{real(below), 1},
//         upper{real(above), -1}
// wrong live-gap-after: nearer.live = nearer.C ==> const real gap = std::min(lower.C + h * rate,
//         upper.C - h * rate); nearer.live = gap
// wrong live-if-either-near: LimitRow nearer ==> const real reach = h * std::abs(rate) + real(0.1)
//         * h; const bool live = lower.C < reach || upper.C < reach; LimitRow nearer ;; nearer.C <
//         h * std::abs(rate) + real(0.1) * h ==> live
// wrong live-lower-only: LimitRow nearer ==> lower.live = lower.C < h * std::abs(rate) + real(0.1)
//         * h; LimitRow nearer ;; nearer.live = nearer.C < h * std::abs(rate) + real(0.1) * h; ==>
// wrong live-only-direction: = nearer ==> = nearer.sign * rate <= 0 && nearer
// wrong lower-c-negated: x - range.lower ==> range.lower - x
// wrong both-h-rate: upper; ==> upper; nearer.C = std::min(lower.C, upper.C);
// wrong sign-upper-limit: lower.C + h * rate < upper.C - h * rate ? lower : upper ==> lower;
//         nearer.C = std::min(lower.C, upper.C)
// wrong minus-0-1-h: + real ==> - real
// wrong not-live-rest: = nearer ==> = rate != 0 && nearer
// wrong not-live-set:
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, -1};
  return lower.C + h * rate < upper.C - h * rate ? lower : upper;
// wrong only-where-passed: nearer.C < h * std::abs(rate) + real(0.1) * h ==> range.lower ==
//         range.upper || nearer.C < 0
// wrong rate-one-side: - h * rate ==>
// wrong abs-int-rate: (rate) ==> (r) ;; rate ? ==> r ? ;; rate ==> r ;; LimitRow ==> const int r =
//         rate; LimitRow
// wrong rate-without-h-choice: h * ==> ;; h * ==>
// wrong gap-above-upper-limit: h; ==> h; if (nearer.sign < 0) nearer.C = x - range.upper;
// wrong gap-end: , 1 ==> + h * rate, 1 ;; - x ==> - x - h * rate ;; + h * rate < upper.C - h * rate
//         ==> < upper.C
// wrong rule-h-rate: < h * std::abs(rate) + ==> + h * rate <
// wrong rule-h-rate: std::abs(rate) ==> rate
// wrong sign-upper-limit: -1 ==> 1
// wrong sign-rate: upper; ==> upper; nearer.sign = rate < 0 ? 1 : -1;
// wrong sign-from-c: upper; ==> upper; nearer.sign = nearer.C < 0 ? -1 : 1;
// wrong signs-rate-exchanged: + h ==> - h ;; upper.C - ==> upper.C +
// wrong without-the-speed: nearer.C < h * std::abs(rate) + ==> range.lower == range.upper ||
//         nearer.C <
// right compared with both limits at once:
  const bool lower = 2 * (x + h * rate) < range.lower + range.upper;
  LimitRow row;
  row.C = lower ? x - range.lower : range.upper - x;
  row.sign = lower ? 1 : -1;
  row.live = row.C <= h * (std::abs(rate) + real(0.1));
  return row;
// right less or equal: < upper ==> <= upper ;; < h ==> <= h
// right where x will be:
  // The middle between the limits decides, with x as it will be.
  const real next = x + h * rate;
  LimitRow row{x - range.lower, 1};
  if (range.upper - next < next - range.lower) row = {range.upper - x, -1};
  row.live = row.C - h * std::abs(rate) < real(0.1) * h || range.lower == range.upper;
  return row;
// right with std,,min_element:
  return [&] {
    LimitRow both[2] = {{x - range.lower, 1}, {range.upper - x, -1}};
    for (LimitRow& row : both) row.live = row.C < h * (std::fabs(rate) + real(0.1));
    return *std::min_element(both, both + 2, [&](const LimitRow& a, const LimitRow& b) {
      return a.C + h * a.sign * rate < b.C + h * b.sign * rate;
    });
  }();
// wrong units "in limit_row (rates as pure numbers and x in s), adding a pure number to s: h is missing":
//         lower.C + h * rate < upper.C - h * rate ? lower : upper ==> upper.C - rate < lower.C +
//         rate ? upper : lower ;; = nearer ==> = range.lower == range.upper || nearer
// right filled in by comparing both ends:
  LimitRow row{range.upper - x, -1};
  if (x - range.lower + h * rate < range.upper - x - h * rate) row = {x - range.lower, 1};
  row.live = row.C < h * std::abs(rate) + real(0.1) * h;
  return row;
// from right filled in by comparing both ends
// wrong min-limits: LimitRow row{range.upper - x, -1}; if (x - range.lower + h * rate < range.upper
//         - x - h * rate) row = {x - range.lower, 1} ==> const real nearest = std::min(range.lower,
//         range.upper); LimitRow row{x - nearest, 1}
// wrong only-direction-rate: row ==> row = rate > 0 ? LimitRow ;; ; if (x - range.lower + h * rate
//         < range.upper - x - h * rate) row = ==> : LimitRow
// wrong never-set: {range.upper - x, -1} ==> ; real sign, gap ;; row = {x - range.lower, 1} ==> {
//         gap = x - range.lower; sign = 1; } else gap = range.upper - x; row = {gap, sign}
