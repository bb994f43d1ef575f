// Exercise 9.4: the inverse of a pivot as a table.
#pragma once

#include "chapters/09_direct/direct.h"
#include "tests/checker/arguments.h"

namespace joints::testing {

/// Of its original entry so much remains at most of a dependent row, and at least of the others.
inline constexpr double largest_error = is_float ? 1e-9 : 1e-12;
inline constexpr double least_pivot = is_float ? 1e-5 : 1e-8;

struct PivotCase {
  std::string words;
  double pivot, original;
};
inline const Arguments<PivotCase> pivot_arguments{{"pivot", &PivotCase::pivot},
                                                  {"original", &PivotCase::original}};

inline std::vector<PivotCase> pivot_cases() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<PivotCase> out{{"a pivot of its whole entry", 2, 2},
                             {"only a rounding error remains", 2 * largest_error, 2},
                             {"half of it remains", 1, 2},
                             {"a pivot of 4", 4, 5},
                             {"a hundredth remains", 0.05, 5},
                             {"both are zero", 0, 0},
                             {"nothing remains", 0, 3},
                             {"rounding error below zero", -largest_error, 1},
                             {"a large pivot below zero", -2, 3}};
  for (const double mass : {1e-9, 1e-4, 1e4, 1e9}) {
    const std::string words = ", entry " + short_number(mass);
    out.push_back({"whole" + words, mass, mass});
    out.push_back({"a thousandth remains" + words, 1e-3 * mass, mass});
    out.push_back({"rounding error" + words, largest_error * mass, mass});
    out.push_back({"the least of a row that is needed" + words, 1.01 * least_pivot * mass, mass});
  }
  out.push_back({"the pivot is not a number", nan, 1});  // the last to be told
  out.push_back({"the entry is not a number", 1, nan});
  return out;
}

inline CaseTable<PivotCase> pivot_table() {
  using Case = PivotCase;
  CaseTable<Case> table{{"9.4", "1 / pivot, and 0 for a dependent row"},
                        {"inverse times |pivot|"}, {}, {}, {}, pivot_cases()};
  table.tolerance = 1e-12;
  table.whole = true;
  // numbers of all sizes: what is compared is the inverse in units of 1/pivot
  const auto scaled = [](auto inverse, const Case& c) {
    const double scale = c.pivot != 0 && std::isfinite(c.pivot) ? std::abs(c.pivot) : 1;
    return Numbers{scale * inverse(c.pivot, c.original)};
  };
  judge(table, inverse_pivot, scaled);
  table.right = [=](const Case& c) {
    const double share = is_float ? 1e-7 : 1e-11;
    return scaled([=](double pivot, double original) {
      return pivot > share * original ? 1 / pivot : 0;
    }, c);
  };
  table.given = [](const Case& c) { return "Given: " + arguments_of(c, pivot_arguments) + "."; };
  add_formulas(table, pivot_arguments);
  table.given = [copy = table](const Case& c) { return copy.given(c) + " " + copy.holds_in(); };
  return table;
}

}  // namespace joints::testing
