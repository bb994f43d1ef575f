// Exercise 3.4 as a table of cases: the row of a limit.
#pragma once

#include <limits>

#include "chapters/03_hinge/hinge.h"
#include "tests/checker/cases.h"

namespace joints::testing {

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
  CaseTable<LimitCase> table{{"3.4", "the row of a limit (h = 1/10 s; live 1 is yes)"},
                             {"C", "sign", "live"}, {}, {}, {}, {}};
  constexpr double h = limit_h;
  judge(table, limit_row, [](auto limit_row, const LimitCase& c) {
    const LimitRow row = limit_row({real(c.lower), real(c.upper)}, real(c.x), real(c.rate),
                                   real(h));
    return Numbers{double(row.C), double(row.sign), row.live ? 1.0 : 0.0};
  });
  table.right = [](const LimitCase& c) {
    const double next = c.x + h * c.rate;
    const bool upper = c.upper - next <= next - c.lower;
    const double C = upper ? c.upper - c.x : c.x - c.lower;
    return Numbers{C, upper ? -1.0 : 1.0, C < h * (std::abs(c.rate) + 0.1) ? 1.0 : 0.0};
  };
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
      limit_case(1, 1, 1.5, -4),       limit_case(1, 1, 0.5, 4),
      limit_case(-1, 2, -0.989995, -1e-4), limit_case(-1, 2, 1.989995, 1e-4)};  // live by the rate
  table.tolerance = 10 * rounding;
  return table;
}

}  // namespace joints::testing
