// Exercise 3.4 as a table of cases with its usual mistakes: the row of a limit.
#pragma once

#include <algorithm>

#include "chapters/03_hinge/hinge.h"
#include "tests/checker/cases.h"

namespace joints::testing {

inline const char* const told_filled_where_live =
    "#filled-where-live C and sign are those of the nearer limit whether it is live or not";
inline const char* const told_live_if_either_near =
    "#live-if-either-near live belongs to the returned limit, not to the other one";
inline const char* const told_live_only_direction =
    "#live-only-direction live while x moves away, too: a neighbour may reverse it within the step";
inline const char* const told_only_direction_rate =
    "#only-direction-rate the limit toward which x moves: the smaller gap at the end of the step "
    "decides";
inline const char* const told_rate_one_side =
    "#rate-one-side the rate counts for both limits: the one gap grows by h rate, the other "
    "shrinks by it";
inline const char* const told_gap_end =
    "#gap-end C is the present gap: its change in the step decides only which limit is returned";
inline const char* const told_sign_rate =
    "#sign-rate the sign is that of the limit: it does not depend on the direction of x";

/// A step of 1/10 s.
struct LimitCase {
  std::string words;
  double lower, upper, x, rate;
};
inline constexpr double limit_h = 0.1;

inline LimitCase limit_case(double lower, double upper, double x, double rate) {
  return {"[" + short_number(lower) + ", " + short_number(upper) + "] x " + short_number(x) +
              " rate " + short_number(rate),
          lower, upper, x, rate};
}

inline CaseTable<LimitCase> limit_table() {
  using Case = LimitCase;
  constexpr double h = limit_h;
  struct Row3 {
    double C, sign;
    bool live;
  };
  const auto numbers = [](const Row3& r) { return Numbers{r.C, r.sign, r.live ? 1.0 : 0.0}; };
  const auto side = [](const Case& c, bool upper) {
    return upper ? Row3{c.upper - c.x, -1, false} : Row3{c.x - c.lower, 1, false};
  };
  const auto smaller_gap_after = [=](const Case& c) {
    return c.upper - c.x - h * c.rate <= c.x - c.lower + h * c.rate;
  };
  const auto live = [](const Case& c, const Row3& r) {
    return r.C < h * std::abs(c.rate) + 0.1 * h;
  };
  const auto build = [=](auto upper, auto change, auto rule) {
    return [=](const Case& c) {
      Row3 row = side(c, upper(c));
      row.live = rule(c, row);
      change(c, row);
      return numbers(row);
    };
  };
  const auto keep = [](const Case&, Row3&) {};
  const auto choosing = [=](auto upper) { return build(upper, keep, live); };
  const auto changed = [=](auto change) { return build(smaller_gap_after, change, live); };
  const auto ruled = [=](auto rule) { return build(smaller_gap_after, keep, rule); };
  // other gaps for the choice and the rule, too
  const auto with_gaps = [=](auto gap) {
    return [=](const Case& c) {
      const Row3 lower{gap(c, false), 1, false}, upper{gap(c, true), -1, false};
      Row3 row = lower.C + h * c.rate < upper.C - h * c.rate ? lower : upper;
      row.live = live(c, row);
      return numbers(row);
    };
  };
  const auto right_gap = [=](const Case& c, bool upper) { return side(c, upper).C; };
  const auto filled_in_where = [=](auto needed) {
    return [=](const Case& c) {
      Row3 row = side(c, smaller_gap_after(c));
      row.live = live(c, row);
      return numbers(needed(row) ? row : Row3{std::numeric_limits<double>::infinity(), 1, false});
    };
  };
  const auto always_upper_negative = [=](const Case& c) {
    Row3 row{c.x - c.upper, -1, false};
    row.live = live(c, row);
    return numbers(row);
  };
  const char* const upper_sign =
      "#sign-upper-limit the sign at the upper limit: C = upper - x shrinks while x grows, so "
      "that dC/dx is -1";
  const char* const upper_gap = "#gap-above-upper-limit C at the upper limit: the gap is upper - "
                                "x, not x - upper";
  const char* const beyond = "#abs-of-c beyond the limit C is negative: no absolute value";
  const char* const lower_gap = "#lower-c-negated C at the lower limit: the gap is x - lower, not "
                                "lower - x";
  const char* const whole = "#abs-int-rate the rate is cut off to a whole number: an int has no "
                            "fraction";
  const char* const way_round =
      "#both-h-rate the limit with the smaller gap now: the smaller gap at the end of the step "
      "decides, where the lower gap has grown by h rate and the upper one has shrunk by it";
  const char* const size = "#rule-h-rate the size of the rate counts, |rate|: a neighbour may "
                           "reverse x within the step";
  const char* const violated = "#only-where-passed live only where the limit is passed already: "
                               "then it is too late. The row must be there in the step before";

  CaseTable<Case> table{{"3.4", "the row of a limit (h = 1/10 s; live 1 is yes)"},
                        {"C", "sign", "live"}, {}, {}, {}, {}};
  table.yours = [=](const Case& c) {
    const Range range{real(c.lower), real(c.upper)};
    const LimitRow row = limit_row(range, real(c.x), real(c.rate), real(h));
    return numbers({double(row.C), double(row.sign), row.live});
  };
  table.right = ruled(live);
  table.mistakes = {
      {upper_sign, changed([](const Case&, Row3& r) { r.sign = 1; })},
      {"the signs are exchanged: +1 at the lower limit, -1 at the upper one",
       changed([](const Case&, Row3& r) { r.sign = -r.sign; })},
      {upper_gap, changed([](const Case&, Row3& r) { r.C *= r.sign; })},
      {upper_gap, build(smaller_gap_after, [](const Case&, Row3& r) { r.C *= r.sign; },
                         [=](const Case& c, Row3 r) { return live(c, {r.sign * r.C, 1, false}); })},
      {upper_gap, always_upper_negative},
      {"the sign of C: it is the gap, positive between the limits",
       changed([](const Case&, Row3& r) { r.C = -r.C; })},
      {beyond, changed([](const Case&, Row3& r) { r.C = std::abs(r.C); })},
      {beyond, build(smaller_gap_after, [](const Case&, Row3& r) { r.C = std::abs(r.C); },
                     [=](const Case& c, Row3 r) { return live(c, {std::abs(r.C), 1, false}); })},
      {told_gap_end,
       changed([](const Case& c, Row3& r) { r.C += h * r.sign * c.rate; })},
      {told_gap_end,
       build(smaller_gap_after, [](const Case& c, Row3& r) { r.C += h * r.sign * c.rate; },
             [=](const Case& c, Row3 r) {
               return live(c, {r.C + h * r.sign * c.rate, 1, false});
             })},
      {violated, ruled([](const Case&, const Row3& r) { return r.C < 0; })},
      {violated, ruled([](const Case&, const Row3& r) { return r.C <= 0; })},
      {violated, build([](const Case& c) { return c.upper - c.x <= c.x - c.lower; }, keep,
                       [](const Case&, const Row3& r) { return r.C < 0; })},
      {"live only if the limit will be passed within the step: the rule is C < h |rate| + 0.1 h",
       ruled([](const Case& c, const Row3& r) { return r.C + h * r.sign * c.rate < 0; })},
      {"#without-the-speed the speed is missing in the rule: C < h |rate| + 0.1 h",
       ruled([](const Case&, const Row3& r) { return r.C < 0.1 * h; })},
      {"#1-10-whole-numbers 0.1 h is missing in the rule: C < h |rate| + 0.1 h",
       ruled([](const Case& c, const Row3& r) { return r.C < h * std::abs(c.rate); })},
      {"#h-0-1-h 0.1, or h, where 0.1 h belongs",
       ruled([](const Case& c, const Row3& r) { return r.C < h * std::abs(c.rate) + 0.1; })},
      {"the rate is not multiplied by h",
       ruled([](const Case& c, const Row3& r) { return r.C < std::abs(c.rate) + 0.1 * h; })},
      {size, ruled([](const Case& c, const Row3& r) { return r.C < h * c.rate + 0.1 * h; })},
      {size,
       ruled([](const Case& c, const Row3& r) { return r.C < -h * r.sign * c.rate + 0.1 * h; })},
      {whole, ruled([=](const Case& c, const Row3& r) {
         return r.C < h * std::abs(std::trunc(c.rate)) + 0.1 * h;
       })},
      {whole, [=](Case c) {
         c.rate = std::trunc(c.rate);
         return build(smaller_gap_after, keep, live)(c);
       }},
      {"#0-1-within-absolute the 0.1 stands outside the absolute value: |rate| + 0.1, not |rate + "
       "0.1|",
       ruled([](const Case& c, const Row3& r) { return r.C < h * std::abs(c.rate + 0.1); })},
      {"#minus-0-1-h 0.1 h is added: C < h |rate| + 0.1 h",
       ruled([](const Case& c, const Row3& r) { return r.C < h * std::abs(c.rate) - 0.1 * h; })},
      {"#0-01-h less than 0.1 h is added (0.01 h, or h twice): C < h |rate| + 0.1 h",
       ruled([](const Case& c, const Row3& r) { return r.C < h * std::abs(c.rate) + 0.01 * h; })},
      {"the rate is squared: C < h |rate| + 0.1 h",
       ruled([](const Case& c, const Row3& r) { return r.C < h * c.rate * c.rate + 0.1 * h; })},
      {"the rate counts twice: C < h |rate| + 0.1 h",
       ruled([](const Case& c, const Row3& r) {
         return r.C < 2 * h * std::abs(c.rate) + 0.1 * h;
       })},
      {"#abs-c-rule beyond the limit a row is live, too: C is negative there, and no absolute "
       "value is taken",
       ruled([](const Case& c, const Row3& r) {
         return std::abs(r.C) < h * std::abs(c.rate) + 0.1 * h;
       })},
      {"C is a gap, it is not divided by h: C < h |rate| + 0.1 h",
       ruled([](const Case& c, const Row3& r) {
         return r.C / h < h * std::abs(c.rate) + 0.1 * h;
       })},
      {"#live-gap-after the gap now decides whether the row is live: C, not C + h dC/dt",
       ruled([](const Case& c, const Row3& r) {
         return r.C + h * r.sign * c.rate < h * std::abs(c.rate) + 0.1 * h;
       })},
      {"#not-live-rest a limit is live at rest, too, whatever the rate is",
       ruled([=](const Case& c, const Row3& r) { return c.rate != 0 && live(c, r); })},
      {told_live_only_direction,
       ruled([=](const Case& c, const Row3& r) { return r.sign * c.rate <= 0 && live(c, r); })},
      {told_live_only_direction,
       ruled([=](const Case& c, const Row3& r) { return r.sign * c.rate < 0 && live(c, r); })},
      {told_live_if_either_near,
       ruled([=](const Case& c, const Row3&) {
         return live(c, side(c, false)) || live(c, side(c, true));
       })},
      {told_live_if_either_near,
       ruled([=](const Case& c, const Row3&) {
         return live(c, side(c, false)) && live(c, side(c, true));
       })},
      {"#h-1-60 h is the argument, not 1/60", [=](const Case& c) {
         const double short_h = 1.0 / 60;
         return build([=](const Case& at) {
                        return at.upper - at.x - short_h * at.rate <=
                               at.x - at.lower + short_h * at.rate;
                      }, keep, [=](const Case& at, const Row3& r) {
                        return r.C < short_h * std::abs(at.rate) + 0.1 * short_h;
                      })(c);
       }},
      {"#live-lower-only live is set for the lower limit alone",
       ruled([=](const Case& c, const Row3& r) { return r.sign > 0 && live(c, r); })},
      {"live is set for the upper limit alone",
       ruled([=](const Case& c, const Row3& r) { return r.sign < 0 && live(c, r); })},
      {"#equal-limits-live-excluded two equal limits hold x: their row is live, too",
       ruled([=](const Case& c, const Row3& r) { return c.lower != c.upper && live(c, r); })},
      {told_filled_where_live,
       filled_in_where([](const Row3& row) { return row.live; })},
      {"#if-lower-passed-else C and sign are those of the nearer limit whether it is passed or not",
       filled_in_where([](const Row3& row) { return row.C < 0; })},
      {told_filled_where_live, [=](const Case& c) {
         Row3 row{std::numeric_limits<double>::infinity(), 1, false};
         for (const bool upper : {false, true})
           if (Row3 one = side(c, upper); live(c, one)) row = one, row.live = true;
         return numbers(row);
       }},
      {"#sign-from-c the sign is that of the limit, whether it is passed or not",
       changed([](const Case&, Row3& r) { r.sign = r.C < 0 ? -1 : 1; })},
      {told_sign_rate,
       changed([](const Case& c, Row3& r) { r.sign = c.rate < 0 ? 1 : -1; })},
      {told_sign_rate,
       changed([](const Case& c, Row3& r) { r.sign = c.rate <= 0 ? 1 : -1; })},
      {lower_gap, with_gaps([=](const Case& c, bool upper) {
         return (upper ? 1 : -1) * right_gap(c, upper);
       })},
      {upper_gap, with_gaps([=](const Case& c, bool upper) {
         return (upper ? -1 : 1) * right_gap(c, upper);
       })},
      {"the signs of both gaps: C is x - lower and upper - x, positive between the limits",
       with_gaps([=](const Case& c, bool upper) { return -right_gap(c, upper); })},
      {"the limits are exchanged: C is x - lower and upper - x",
       with_gaps([=](const Case& c, bool upper) { return -right_gap(c, !upper); })},
      {"#c-clamped-0 beyond the limit C is negative: it does not end at 0",
       with_gaps([=](const Case& c, bool upper) { return std::max(right_gap(c, upper), 0.0); })},
      {"#int-c the gaps are cut off to whole numbers: an int has no fraction",
       with_gaps([=](const Case& c, bool upper) {
         const double gap = right_gap(c, upper);
         return std::isfinite(gap) ? std::trunc(gap) : double(std::numeric_limits<int>::min());
       })},
      {"#abs-c-choice no absolute value in the choice: beyond a limit the gap is negative, that "
       "is less",
       choosing([=](const Case& c) {
         return !(std::abs(side(c, false).C + h * c.rate) < std::abs(side(c, true).C - h * c.rate));
       })},
      {"#rate-without-h-choice h is missing in the choice of the limit: C + h dC/dt",
       choosing([=](const Case& c) {
         return !(side(c, false).C + c.rate < side(c, true).C - c.rate);
       })},
      {told_rate_one_side,
       choosing([=](const Case& c) { return !(side(c, false).C + h * c.rate < side(c, true).C); })},
      {told_rate_one_side,
       choosing([=](const Case& c) { return !(side(c, false).C < side(c, true).C - h * c.rate); })},
      {"#first-live-one-wins the lower limit wherever it is live: the smaller gap at the end of "
       "the step decides",
       choosing([=](const Case& c) { return !live(c, side(c, false)); })},
      {size, ruled([](const Case& c, const Row3& r) { return r.C < -h * c.rate + 0.1 * h; })},
      {"#c-over-h C is a gap: it is not divided by h",
       changed([](const Case&, Row3& r) { r.C /= h; })},
      {"#greater the rule the wrong way round: live where C is small",
       ruled([=](const Case& c, const Row3& r) { return !live(c, r); })},
      {"#not-live-set live is never set", ruled([](const Case&, const Row3&) { return false; })},
      {"always live: a limit that is far away needs no row",
       ruled([](const Case&, const Row3&) { return true; })},
      {way_round, choosing([](const Case& c) { return c.upper - c.x <= c.x - c.lower; })},
      {told_only_direction_rate,
       choosing([](const Case& c) { return c.rate > 0; })},
      {told_only_direction_rate,
       choosing([](const Case& c) { return c.rate >= 0; })},
      {"the limit with the larger gap is taken", choosing([=](const Case& c) {
         return !smaller_gap_after(c);
       })},
      {"#signs-rate-exchanged the sign of the rate: at the end of the step x is x + h rate",
       choosing([](const Case& c) {
         return c.upper - c.x + h * c.rate <= c.x - c.lower - h * c.rate;
       })},
      {"#min-limits the upper limit is ignored",
       choosing([](const Case&) { return false; })},
      {"the lower limit is ignored", choosing([](const Case&) { return true; })}};
  const double none = std::numeric_limits<double>::infinity();
  table.cases = {
      limit_case(-1, 2, 0, 0),         limit_case(-1, 2, 1, 0),       // well inside
      limit_case(-1, 2, -0.9, -0.5),   limit_case(-1, 2, 1.9, 0.5),   // near enough to see
      limit_case(-1, 2, -0.9, -3),     limit_case(-1, 2, 1.9, 3),     // reached in this step
      limit_case(-1, 2, -0.9, 3),      limit_case(-1, 2, 1.9, -3),    // left in this step
      limit_case(-1, 2, -0.995, 0),    limit_case(-1, 2, 1.995, 0),   // close, at rest
      limit_case(-1, 2, -0.98, 0),     limit_case(-1, 2, 1.98, 0),    // a little less close
      limit_case(-1, 2, -5, 0),        limit_case(-1, 2, 2.3, 0),     // beyond
      limit_case(-1, 2, -1.05, -2),    limit_case(-1, 2, 2.05, 2),    // beyond, and on the way out
      limit_case(-1, 2, -0.25, 30),    limit_case(-1, 2, 1.25, -30),  // fast toward the far side
      limit_case(-1, 2, 0, -30),       limit_case(-1, 2, 1, 30),      // toward the near one
      limit_case(-1, 2, -0.25, 9),     limit_case(-1, 2, 1.25, -9),   // the far side, out of reach
      limit_case(-1, 2, 0.35, 1.9),    limit_case(-1, 2, 0.65, -1.9), // the other one is nearer now
      limit_case(-1, 2, 1.94, 0.7),    limit_case(-1, 2, -0.94, -0.7),
      limit_case(-1, 2, 1.95, -0.5),   limit_case(-1, 2, -0.95, -0.5),
      limit_case(-1, 2, 1.9995, 0),    limit_case(-1, 2, -0.9995, 0), // nearly there, at rest
      limit_case(-none, 2, -100, 0),   limit_case(-none, 2, 1.9, 3),  // one limit only
      limit_case(-1, none, 50, 0),     limit_case(-1, none, -0.9, -3),
      limit_case(-none, 2, 1.5, -30),  limit_case(-1, none, -0.5, 30),
      limit_case(-10, 10, 9.9, 3),     limit_case(-10, 10, 7, 0),     // more than a whole turn
      limit_case(1, 1, 1.5, 0),        limit_case(1, 1, 0.5, 0),      // held
      limit_case(1, 1, 1.5, -4),       limit_case(1, 1, 0.5, 4)};
  table.tolerance = 10 * rounding;
  return table;
}

}  // namespace joints::testing
