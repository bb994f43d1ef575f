// Exercises 3.4 and 3.5 as tables of cases, each with its usual mistakes: the limit, the motor.
#pragma once

#include <algorithm>

#include "chapters/03_hinge/hinge.h"
#include "tests/checker/cases.h"

namespace joints::testing {

// ---- 3.4 the row of a limit ---------------------------------------------------------------------

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
  const auto less_room_after = [=](const Case& c) {
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
  const auto changed = [=](auto change) { return build(less_room_after, change, live); };
  const auto ruled = [=](auto rule) { return build(less_room_after, keep, rule); };
  const auto always_upper_negative = [=](const Case& c) {
    Row3 row{c.x - c.upper, -1, false};
    row.live = live(c, row);
    return numbers(row);
  };
  const char* const upper_sign =
      "the sign at the upper limit: C = upper - x shrinks while x grows, so that dC/dx is -1";
  const char* const upper_room = "C at the upper limit: the room left is upper - x, not x - upper";
  const char* const beyond = "beyond the limit C is negative: no absolute value";
  const char* const size = "the size of the rate counts, |rate|: a neighbour may turn x round "
                           "within the step";
  const char* const violated = "live only where the limit is passed already: then it is too late. "
                               "The row must be there in the step before";

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
      {upper_room, changed([](const Case&, Row3& r) { r.C *= r.sign; })},
      {upper_room, build(less_room_after, [](const Case&, Row3& r) { r.C *= r.sign; },
                         [=](const Case& c, Row3 r) { return live(c, {r.sign * r.C, 1, false}); })},
      {upper_room, always_upper_negative},
      {"the sign of C: it is the room left, positive between the limits",
       changed([](const Case&, Row3& r) { r.C = -r.C; })},
      {beyond, changed([](const Case&, Row3& r) { r.C = std::abs(r.C); })},
      {beyond, build(less_room_after, [](const Case&, Row3& r) { r.C = std::abs(r.C); },
                     [=](const Case& c, Row3 r) { return live(c, {std::abs(r.C), 1, false}); })},
      {"C is the room now: what the rate does to it in the step decides only which limit it is",
       changed([](const Case& c, Row3& r) { r.C += h * r.sign * c.rate; })},
      {"C is the room now: what the rate does to it in the step decides only which limit it is",
       build(less_room_after, [](const Case& c, Row3& r) { r.C += h * r.sign * c.rate; },
             [=](const Case& c, Row3 r) {
               return live(c, {r.C + h * r.sign * c.rate, 1, false});
             })},
      {violated, ruled([](const Case&, const Row3& r) { return r.C < 0; })},
      {violated, ruled([](const Case&, const Row3& r) { return r.C <= 0; })},
      {violated, build([](const Case& c) { return c.upper - c.x <= c.x - c.lower; }, keep,
                       [](const Case&, const Row3& r) { return r.C < 0; })},
      {"live only if the limit will be passed within the step: the rule is C < h |rate| + 0.1 h",
       ruled([](const Case& c, const Row3& r) { return r.C + h * r.sign * c.rate < 0; })},
      {"the speed is missing in the rule: C < h |rate| + 0.1 h",
       ruled([](const Case&, const Row3& r) { return r.C < 0.1 * h; })},
      {"0.1 h is missing in the rule: C < h |rate| + 0.1 h",
       ruled([](const Case& c, const Row3& r) { return r.C < h * std::abs(c.rate); })},
      {"0.1 where 0.1 h belongs",
       ruled([](const Case& c, const Row3& r) { return r.C < h * std::abs(c.rate) + 0.1; })},
      {"the rate is not multiplied by h",
       ruled([](const Case& c, const Row3& r) { return r.C < std::abs(c.rate) + 0.1 * h; })},
      {size, ruled([](const Case& c, const Row3& r) { return r.C < h * c.rate + 0.1 * h; })},
      {size,
       ruled([](const Case& c, const Row3& r) { return r.C < -h * r.sign * c.rate + 0.1 * h; })},
      {"the rule the wrong way round: live where C is small",
       ruled([=](const Case& c, const Row3& r) { return !live(c, r); })},
      {"live is never set", ruled([](const Case&, const Row3&) { return false; })},
      {"always live: a limit that is far away needs no row",
       ruled([](const Case&, const Row3&) { return true; })},
      {"the limit with less room now: the one with less room at the end of the step counts",
       choosing([](const Case& c) { return c.upper - c.x <= c.x - c.lower; })},
      {"the limit toward which x moves: the one with less room at the end of the step counts",
       choosing([](const Case& c) { return c.rate > 0; })},
      {"the limit toward which x moves: the one with less room at the end of the step counts",
       choosing([](const Case& c) { return c.rate >= 0; })},
      {"the limit with more room is taken", choosing([=](const Case& c) {
         return !less_room_after(c);
       })},
      {"the sign of the rate: at the end of the step x is x + h rate", choosing([](const Case& c) {
         return c.upper - c.x + h * c.rate <= c.x - c.lower - h * c.rate;
       })},
      {"the upper limit is never looked at", choosing([](const Case&) { return false; })},
      {"the lower limit is never looked at", choosing([](const Case&) { return true; })}};
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
      limit_case(-none, 2, -100, 0),   limit_case(-none, 2, 1.9, 3),  // one limit only
      limit_case(-1, none, 50, 0),     limit_case(-1, none, -0.9, -3),
      limit_case(-none, 2, 1.5, -30),  limit_case(-1, none, -0.5, 30),
      limit_case(-10, 10, 9.9, 3),     limit_case(-10, 10, 7, 0),     // more than a whole turn
      limit_case(1, 1, 1.5, 0),        limit_case(1, 1, 0.5, 0),      // held
      limit_case(1, 1, 1.5, -4),       limit_case(1, 1, 0.5, 4)};
  table.tolerance = 10 * rounding;
  return table;
}

// ---- 3.5 the motor ------------------------------------------------------------------------------

/// One visit, in a step of 1/10 s.
struct MotorCase {
  std::string words;
  double rate, K, speed, strength, sum;
};
inline constexpr double motor_h = 0.1;

inline CaseTable<MotorCase> motor_table() {
  using Case = MotorCase;
  constexpr double h = motor_h;
  const auto clamped = [](double a, double bound) { return std::clamp(a, -bound, bound); };
  const auto lack = [](const Case& c) { return -(c.rate - c.speed) / c.K; };
  // a motor whose sum would be `wanted` without its bound
  const auto motor = [=](auto wanted, auto bound) {
    return [=](const Case& c) {
      const double sum = clamped(wanted(c), bound(c));
      return Numbers{sum - c.sum, sum};
    };
  };
  const auto bound = [](const Case& c) { return h * c.strength; };
  const auto wanting = [=](auto wanted) { return motor(wanted, bound); };
  const auto wanted = [=](const Case& c) { return c.sum + lack(c); };
  const auto bounded = [=](auto other) { return motor(wanted, other); };
  const auto right = motor(wanted, bound);
  const char* const each = "each visit is clamped: it is the sum over all visits of a step that "
                           "stays within h strength";
  const char* const no_h =
      "the bound is h strength: an impulse is a torque times a time, and h is missing";
  const char* const not_stored = "the sum is not stored";
  const char* const sign = "the sign: the impulse works against J V - speed";

  CaseTable<Case> table{{"3.5", "the impulse of a motor"}, {"returned", "new sum"}, {}, {}, {}, {}};
  table.yours = [=](const Case& c) {
    real sum = real(c.sum);
    const real change = motor_impulse(real(c.rate), real(c.K),
                                      {real(c.speed), real(c.strength)}, real(h), sum);
    return Numbers{double(change), double(sum)};
  };
  table.right = right;
  table.mistakes = {
      {"the sign of the speed: the motor wants J V - speed = 0, not J V + speed = 0",
       wanting([](const Case& c) { return c.sum - (c.rate + c.speed) / c.K; })},
      {sign, wanting([=](const Case& c) { return c.sum - lack(c); })},
      {no_h, bounded([](const Case& c) { return c.strength; })},
      {"the bound is h strength: times h, not divided by h",
       bounded([](const Case& c) { return c.strength / h; })},
      {each,
       [=](const Case& c) {
         const double change = clamped(lack(c), bound(c));
         return Numbers{change, c.sum + change};
       }},
      {each,
       [=](const Case& c) {
         const double change = clamped(wanted(c) - c.sum, bound(c));
         return Numbers{change, c.sum};
       }},
      {"each visit is clamped, and h is missing: it is the sum that stays within h strength",
       [=](const Case& c) {
         const double change = clamped(lack(c), c.strength);
         return Numbers{change, c.sum + change};
       }},
      {"nothing is clamped", bounded([](const Case&) { return 1e30; })},
      {"only the upper bound is there: the torque is bounded either way",
       [=](const Case& c) {
         const double sum = std::min(wanted(c), bound(c));
         return Numbers{sum - c.sum, sum};
       }},
      {"only the lower bound is there: the torque is bounded either way",
       [=](const Case& c) {
         const double sum = std::max(wanted(c), -bound(c));
         return Numbers{sum - c.sum, sum};
       }},
      {"the sum is kept from 0 to h strength: the torque is bounded either way",
       [=](const Case& c) {
         const double sum = std::clamp(wanted(c), 0.0, bound(c));
         return Numbers{sum - c.sum, sum};
       }},
      {"the new sum is added to the old one: it takes its place",
       [=](const Case& c) { return Numbers{right(c)[1], c.sum + right(c)[1]}; }},
      {not_stored, [=](const Case& c) { return Numbers{right(c)[0], c.sum}; }},
      {"the sum that is stored is not clamped",
       [=](const Case& c) { return Numbers{right(c)[0], wanted(c)}; }},
      {"the new sum is returned instead of its change",
       [=](const Case& c) { return Numbers{right(c)[1], right(c)[1]}; }},
      {"what was wanted is returned: return by how much the sum changed",
       [=](const Case& c) { return Numbers{lack(c), right(c)[1]}; }},
      {"what was wanted is returned: return by how much the sum changed",
       [=](const Case& c) { return Numbers{wanted(c), right(c)[1]}; }},
      {"the sign of the change: new sum minus old sum",
       [=](const Case& c) { return Numbers{-right(c)[0], right(c)[1]}; }},
      {"0 is returned: keep the old sum before the new one is stored",
       [=](const Case& c) { return Numbers{0, right(c)[1]}; }},
      {"the sum so far is missing in what is wanted", wanting(lack)},
      {"the change is added to the sum twice",
       [=](const Case& c) { return Numbers{right(c)[0], right(c)[1] + right(c)[0]}; }},
      {"times K where it must be divided by K",
       wanting([](const Case& c) { return c.sum - (c.rate - c.speed) * c.K; })},
      {"K is missing: divide by it",
       wanting([](const Case& c) { return c.sum - (c.rate - c.speed); })},
      {"the old sum is divided by K, too",
       wanting([](const Case& c) { return (c.sum - (c.rate - c.speed)) / c.K; })},
      {"the speed of the motor is missing: this is a brake",
       wanting([](const Case& c) { return c.sum - c.rate / c.K; })},
      {"the rate is missing: only what lacks to the speed is wanted",
       wanting([](const Case& c) { return c.sum + c.speed / c.K; })},
      {"the impulse is multiplied by h: it is an impulse already, not a torque",
       wanting([=](const Case& c) { return c.sum + h * lack(c); })}};
  const auto add = [&](double rate, double K, double speed, double strength, double sum) {
    table.cases.push_back({"rate " + short_number(rate) + " sum " + short_number(sum), rate, K,
                           speed, strength, sum});
  };
  for (const double way : {1, -1}) {
    add(way * 0, 0.5, way * 3, 10, 0);             // the two visits of the text
    add(way * 0.5, 0.5, way * 3, 10, way * 1);
    add(way * 2.9, 0.5, way * 3, 10, 0);           // within the bound
    add(way * 2.9, 0.5, way * 3, 10, way * 0.5);
    add(way * 3.25, 0.5, way * 3, 10, way * 0.75);  // too fast: gives back
    add(way * 9, 0.5, way * 3, 10, way * 0.5);     // much too fast: brakes with all it has
    add(way * 1, 2.5, way * 4, 30, way * 1.5);
    add(way * 1, 2.5, way * 4, 0, 0);              // off
  }
  table.tolerance = 10 * rounding;
  return table;
}

}  // namespace joints::testing
