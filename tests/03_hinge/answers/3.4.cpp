// wrong drawn-threshold: nearer.live = ==> if (std::abs(nearer.C) < real(1e-9)) nearer.C = 0;
//         nearer.live =
// mistake "less than 0.1 h is added (0.01 h, or h twice): C < h |rate| + 0.1 h": 0.1 ==> 0.01
// mistake "the 0.1 stands outside the absolute value: |rate| + 0.1, not |rate + 0.1|": (rate) +
//         real(0.1) * h ==> (rate + real(0.1))
// mistake "0.1 h is missing in the rule: C < h |rate| + 0.1 h": real(0.1) ==> 1 / 10
// mistake "beyond the limit C is negative: it does not end at 0": {x - range.lower, 1},
//         upper{range.upper - x, -1} ==> {std::max(x - range.lower, real(0)), 1}; LimitRow
//         upper{std::max(range.upper - x, real(0)), -1}
// mistake "C is a gap: it is not divided by h": {x - range.lower, 1}, upper{range.upper - x, -1}
//         ==> {(x - range.lower) / h, 1}, upper{(range.upper - x) / h, -1} ;; h * rate < upper.C -
//         h * ==> rate < upper.C - ;; h * ==> ;; * h ==>
// mistake "beyond the limit C is negative: no absolute value": x - range.lower ==> std::abs(x -
//         range.lower) ;; range.upper - x ==> std::abs(range.upper - x)
// mistake "no absolute value in the choice: beyond a limit the gap is negative, that is less":
//         lower.C + h * rate < upper.C - h * rate ==> std::abs(lower.C + h * rate) <
//         std::abs(upper.C - h * rate)
// mistake "beyond the limit a row is live, too: C is negative there, and no absolute value is
//         taken": nearer.C ==> std::abs(nearer.C)
// mistake "the rate is cut off to a whole number: an int has no fraction": (rate) ==> (int(rate))
// mistake "the limit with the smaller gap now: the smaller gap at the end of the step decides,
//         where the lower gap has grown by h rate and the upper one has shrunk by it": - h ==> + h
// mistake "two equal limits hold x: their row is live, too": = nearer ==> = range.lower !=
//         range.upper && nearer
// mistake "C and sign are those of the nearer limit whether it is live or not":
  LimitRow row;
  if (x - range.lower < h * std::abs(rate) + real(0.1) * h) row = {x - range.lower, 1, true};
  if (range.upper - x < h * std::abs(rate) + real(0.1) * h) row = {range.upper - x, -1, true};
  return row;
// mistake "the lower limit wherever it is live: the smaller gap at the end of the step decides":
//         LimitRow nearer = lower.C + h * rate < upper.C - h * rate ? lower : upper; nearer.live =
//         nearer ==> lower.live = lower.C < h * std::abs(rate) + real(0.1) * h; upper.live = upper
//         ;; nearer ==> lower.live ? lower : upper
// mistake "the rule the wrong way round: live where C is small": < h ==> > h
// mistake "0.1, or h, where 0.1 h belongs": real(0.1) * ==>
// mistake "h is the argument, not 1/60": h * rate < upper.C - h * rate ==> rate / 60 < upper.C -
//         rate / 60 ;; h * ==> ;; + real(0.1) * h ==> / 60 + real(0.1) / 60
// mistake "C and sign are those of the nearer limit whether it is passed or not":
  LimitRow row;
  if (x < range.lower) row = {x - range.lower, 1, true};
  else if (x > range.upper) row = {range.upper - x, -1, true};
  return row;
// mistake "the gaps are cut off to whole numbers: an int has no fraction": LimitRow lower{x -
//         range.lower, 1}, upper{range.upper - x, -1} ==> const int below = x - range.lower, above
//         = range.upper - x; LimitRow lower{real(below), 1}, upper{real(above), -1}
// mistake "the gap now decides whether the row is live: C, not C + h dC/dt": nearer.live = nearer.C
//         ==> const real gap = std::min(lower.C + h * rate, upper.C - h * rate); nearer.live = gap
// mistake "live belongs to the returned limit, not to the other one": LimitRow nearer ==> const
//         real reach = h * std::abs(rate) + real(0.1) * h; const bool live = lower.C < reach ||
//         upper.C < reach; LimitRow nearer ;; nearer.C < h * std::abs(rate) + real(0.1) * h ==>
//         live
// mistake "live is set for the lower limit alone": LimitRow nearer ==> lower.live = lower.C < h *
//         std::abs(rate) + real(0.1) * h; LimitRow nearer ;; nearer.live = nearer.C < h *
//         std::abs(rate) + real(0.1) * h; ==>
// mistake "live while x moves away, too: a neighbour may reverse it within the step": = nearer ==>
//         = nearer.sign * rate <= 0 && nearer
// mistake "C at the lower limit: the gap is x - lower, not lower - x": x - range.lower ==>
//         range.lower - x
// mistake "the limit with the smaller gap now: the smaller gap at the end of the step decides,
//         where the lower gap has grown by h rate and the upper one has shrunk by it": upper; ==>
//         upper; nearer.C = std::min(lower.C, upper.C);
// mistake "the sign at the upper limit: C = upper - x shrinks while x grows, so that dC/dx is -1":
//         lower.C + h * rate < upper.C - h * rate ? lower : upper ==> lower; nearer.C =
//         std::min(lower.C, upper.C)
// mistake "0.1 h is added: C < h |rate| + 0.1 h": + real ==> - real
// mistake "a limit is live at rest, too, whatever the rate is": = nearer ==> = rate != 0 && nearer
// mistake "live is never set":
  LimitRow lower{x - range.lower, 1}, upper{range.upper - x, -1};
  return lower.C + h * rate < upper.C - h * rate ? lower : upper;
// mistake "live only where the limit is passed already: then it is too late. The row must be there
//         in the step before": nearer.C < h * std::abs(rate) + real(0.1) * h ==> range.lower ==
//         range.upper || nearer.C < 0
// mistake "the rate counts for both limits: the one gap grows by h rate, the other shrinks by it":
//         - h * rate ==>
// mistake "the rate is cut off to a whole number: an int has no fraction": (rate) ==> (r) ;; rate ?
//         ==> r ? ;; rate ==> r ;; LimitRow ==> const int r = rate; LimitRow
// mistake "h is missing in the choice of the limit: C + h dC/dt": h * ==> ;; h * ==>
// mistake "C at the upper limit: the gap is upper - x, not x - upper": h; ==> h; if (nearer.sign <
//         0) nearer.C = x - range.upper;
// mistake "C is the present gap: its change in the step decides only which limit is returned": , 1
//         ==> + h * rate, 1 ;; - x ==> - x - h * rate ;; + h * rate < upper.C - h * rate ==> <
//         upper.C
// mistake "the size of the rate counts, |rate|: a neighbour may reverse x within the step": < h *
//         std::abs(rate) + ==> + h * rate <
// mistake "the size of the rate counts, |rate|: a neighbour may reverse x within the step":
//         std::abs(rate) ==> rate
// mistake "the sign at the upper limit: C = upper - x shrinks while x grows, so that dC/dx is -1":
//         -1 ==> 1
// mistake "the sign is that of the limit: it does not depend on the direction of x": upper; ==>
//         upper; nearer.sign = rate < 0 ? 1 : -1;
// mistake "the sign is that of the limit, whether it is passed or not": upper; ==> upper;
//         nearer.sign = nearer.C < 0 ? -1 : 1;
// mistake "the sign of the rate: at the end of the step x is x + h rate": + h ==> - h ;; upper.C -
//         ==> upper.C +
// mistake "the speed is missing in the rule: C < h |rate| + 0.1 h": nearer.C < h * std::abs(rate) +
//         ==> range.lower == range.upper || nearer.C <
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
// wrong units "in limit_row (rates as pure numbers and x in s), adding a pure number to s: h is
//         missing":  lower.C + h * rate < upper.C - h * rate ? lower : upper ==> upper.C - rate <
//         lower.C + rate ? upper : lower ;; = nearer ==> = range.lower == range.upper || nearer
// right filled in by comparing both ends:
  LimitRow row{range.upper - x, -1};
  if (x - range.lower + h * rate < range.upper - x - h * rate) row = {x - range.lower, 1};
  row.live = row.C < h * std::abs(rate) + real(0.1) * h;
  return row;
// mistake "the signs are exchanged: +1 at the lower limit, -1 at the upper one": lower, 1} ==>
//         lower, -1} ;; x, -1} ==> x, 1}
// mistake "C at the upper limit: the gap is upper - x, not x - upper": nearer.live = ==> if
//         (nearer.sign < 0) nearer.C = x - range.upper; nearer.live =
// mistake "C at the upper limit: the gap is upper - x, not x - upper": lower.C + h * rate < upper.C
//         - h * rate ? lower : upper ==> LimitRow{x - range.upper, -1}
// mistake "C at the upper limit: the gap is upper - x, not x - upper": range.upper - x ==> x -
//         range.upper
// mistake "the sign of C: it is the gap, positive between the limits": return ==> nearer.C =
//         -nearer.C; return
// mistake "beyond the limit C is negative: no absolute value": return ==> nearer.C =
//         std::abs(nearer.C); return
// mistake "beyond the limit C is negative: no absolute value": nearer.live = ==> nearer.C =
//         std::abs(nearer.C); nearer.live =
// mistake "C is the present gap: its change in the step decides only which limit is returned":
//         return ==> nearer.C += h * nearer.sign * rate; return
// mistake "live only where the limit is passed already: then it is too late. The row must be there
//         in the step before": nearer.C < h * std::abs(rate) + real(0.1) * h ==> nearer.C < 0
// mistake "live only where the limit is passed already: then it is too late. The row must be there
//         in the step before": nearer.C < h * std::abs(rate) + real(0.1) * h ==> nearer.C <= 0
// mistake "live only where the limit is passed already: then it is too late. The row must be there
//         in the step before": lower.C + h * rate < upper.C - h * rate ==> lower.C < upper.C ;;
//         nearer.C < h * std::abs(rate) + real(0.1) * h ==> nearer.C < 0
// mistake "live only if the limit will be passed within the step: the rule is C < h |rate| + 0.1
//         h": nearer.C < h * std::abs(rate) + real(0.1) * h ==> nearer.C + h * nearer.sign * rate <
//         0
// mistake "the speed is missing in the rule: C < h |rate| + 0.1 h": h * std::abs(rate) + ==>
// mistake "the rate is not multiplied by h": h * std::abs ==> std::abs
// mistake "the size of the rate counts, |rate|: a neighbour may reverse x within the step": h *
//         std::abs(rate) ==> -h * nearer.sign * rate
// mistake "the rate is squared: C < h |rate| + 0.1 h": std::abs(rate) ==> rate * rate
// mistake "the rate counts twice: C < h |rate| + 0.1 h": h * std::abs ==> 2 * h * std::abs
// mistake "C is a gap, it is not divided by h: C < h |rate| + 0.1 h": = nearer.C ==> = nearer.C / h
// mistake "live while x moves away, too: a neighbour may reverse it within the step": = nearer ==>
//         = nearer.sign * rate < 0 && nearer
// mistake "live belongs to the returned limit, not to the other one": LimitRow nearer ==> const
//         real reach = h * std::abs(rate) + real(0.1) * h; const bool live = lower.C < reach &&
//         upper.C < reach; LimitRow nearer ;; nearer.C < h * std::abs(rate) + real(0.1) * h ==>
//         live
// mistake "live is set for the upper limit alone": = nearer ==> = nearer.sign < 0 && nearer
// mistake "C and sign are those of the nearer limit whether it is live or not": return nearer ==>
//         return nearer.live ? nearer : LimitRow{}
// mistake "C and sign are those of the nearer limit whether it is passed or not": return nearer ==>
//         return nearer.C < 0 ? nearer : LimitRow{}
// mistake "the sign is that of the limit: it does not depend on the direction of x": return ==>
//         nearer.sign = rate <= 0 ? 1 : -1; return
// mistake "the signs of both gaps: C is x - lower and upper - x, positive between the limits": x -
//         range.lower ==> range.lower - x ;; range.upper - x ==> x - range.upper
// mistake "the limits are exchanged: C is x - lower and upper - x": x - range.lower ==> x -
//         range.upper ;; upper{range.upper ==> upper{range.lower
// mistake "the rate counts for both limits: the one gap grows by h rate, the other shrinks by it":
//         lower.C + h * rate ==> lower.C
// mistake "C is a gap: it is not divided by h": return ==> nearer.C /= h; return
// mistake "always live: a limit that is far away needs no row": nearer.C < h * std::abs(rate) +
//         real(0.1) * h ==> true
// mistake "the limit toward which x moves: the smaller gap at the end of the step decides": lower.C
//         + h * rate < upper.C - h * rate ==> rate < 0
// mistake "the limit toward which x moves: the smaller gap at the end of the step decides": lower.C
//         + h * rate < upper.C - h * rate ==> rate <= 0
// mistake "the limit with the larger gap is taken": rate < upper ==> rate > upper
// mistake "the upper limit is ignored": lower.C + h * rate < upper.C - h * rate ? lower : upper ==>
//         lower
// mistake "the lower limit is ignored": lower.C + h * rate < upper.C - h * rate ? lower : upper ==>
//         upper
// mistake "the limits and x are in radians already: nothing is converted": x - range.lower ==> x -
//         glm::radians(range.lower) ;; range.upper - x ==> glm::radians(range.upper) - x
// mistake "the limits and x are in radians already: nothing is converted": x - range.lower ==> x -
//         glm::degrees(range.lower) ;; range.upper - x ==> glm::degrees(range.upper) - x
// mistake "the limits and x are in radians already: nothing is converted": x - range.lower ==>
//         glm::degrees(x - range.lower) ;; range.upper - x ==> glm::degrees(range.upper - x)
// mistake "the limits and x are in radians already: nothing is converted": return ==> nearer.C =
//         glm::degrees(nearer.C); return
// mistake "a range with one limit has its row, too: the gap to the other one is infinite": LimitRow
//         lower ==> if (!std::isfinite(range.lower) || !std::isfinite(range.upper)) return {};
//         LimitRow lower
// mistake "a range with one limit has its row, too: the gap to the other one is infinite": LimitRow
//         lower ==> if (!std::isfinite(range.upper)) return {}; LimitRow lower
// mistake "a range with one limit has its row, too: the gap to the other one is infinite": LimitRow
//         lower ==> if (!std::isfinite(range.lower)) return {}; LimitRow lower
// from right filled in by comparing both ends
// mistake "the upper limit is ignored": LimitRow row{range.upper - x, -1}; if (x - range.lower + h
//         * rate < range.upper - x - h * rate) row = {x - range.lower, 1} ==> const real nearest =
//         std::min(range.lower, range.upper); LimitRow row{x - nearest, 1}
// mistake "the limit toward which x moves: the smaller gap at the end of the step decides": row ==>
//         row = rate > 0 ? LimitRow ;; ; if (x - range.lower + h * rate < range.upper - x - h *
//         rate) row = ==> : LimitRow
// wrong never-set: {range.upper - x, -1} ==> ; real sign, gap ;; row = {x - range.lower, 1} ==> {
//         gap = x - range.lower; sign = 1; } else gap = range.upper - x; row = {gap, sign}
