// The count of turns of exercise 3.3 as a table of cases.
#pragma once

#include <numbers>

#include "chapters/03_hinge/hinge.h"
#include "tests/checker/cases.h"

namespace joints::testing {

struct TurnsCase {
  std::string words;
  double measured, expected;
};

inline CaseTable<TurnsCase> turns_table() {
  CaseTable<TurnsCase> table{{"3.3", "counting turns", 2}, {"unwrapped"}, {}, {}, {}, {}};
  constexpr double turn = 2 * std::numbers::pi;
  judge(table, unwrapped, [](auto unwrapped, const TurnsCase& c) {
    return Numbers{double(unwrapped(real(c.measured), real(c.expected)))};
  });
  table.right = [](const TurnsCase& c) {
    return Numbers{c.measured + turn * std::round((c.expected - c.measured) / turn)};
  };
  for (const double k : {0, 1, -1, 2, -2, 7, -7, 60, -60})
    for (const double measured : {-3.1, -1.2, 0.4, 3.0, 4.2})
      for (const double off : {-2.9, -0.5, 0.2, 3.0}) {
        const double expected = std::round(100 * (measured + turn * k + off)) / 100;
        table.cases.push_back({short_number(measured) + " near " + short_number(expected),
                               measured, expected});
      }
  for (const double expected : {0.0, 1e-12, -1e-9, 1e-7, -1e-4})  // nothing small is left out
    for (const double k : {0, 3, -2})
      for (const double off : {0.0, 1e-8, -1e-5, 0.4, -2.9})
        table.cases.push_back({"expected near 0", expected + turn * k + off, expected});
  table.tolerance = is_float ? 1e-3 : 1e-9;
  return table;
}

}  // namespace joints::testing
