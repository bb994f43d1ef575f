// Exercise 9.7: the side of a bounded row as a table.
#pragma once

#include "chapters/09_direct/direct.h"
#include "tests/checker/cases.h"

namespace joints::testing {

struct SideCase {
  std::string words;
  Side now;
  double impulse, lower, upper, rate;
};
inline std::string side_in_words(Side side) {
  return side == Side::lower ? "at its lower bound"
         : side == Side::upper ? "at its upper bound" : "free";
}
inline std::string side_given(const SideCase& c) {
  return "Case: " + side_in_words(c.now) + ", impulse " + short_number(c.impulse) +
         " N s, bounds " + short_number(c.lower) + " and " + short_number(c.upper) +
         " N s, rate " + short_number(c.rate) + " m/s.";
}

inline std::vector<SideCase> side_cases() {
  const double inf = std::numeric_limits<double>::infinity();
  std::vector<SideCase> out;
  for (const auto& [lower, upper] : {std::pair{0.0, inf}, {-2.0, 3.0}, {-inf, 0.0}, {-inf, inf},
                                     {0.0, 0.0}, {1.0, 4.0}, {-5.0, -1.0}}) {
    const double small = 1e-9;
    std::vector<double> impulses{-7, -1.5, -0.5, 0, 0.5, 1.5, 7};
    for (const double bound : {lower, upper})
      if (std::isfinite(bound))
        for (const double off : {-small, 0.0, small}) impulses.push_back(bound + off);
    for (const double impulse : impulses)
      for (const double rate : {-2.0, -small, 0.0, small, 2.0})
        out.push_back({"", Side::free, impulse, lower, upper, rate});
    for (const Side side : {Side::lower, Side::upper}) {
      const double impulse = side == Side::lower ? lower : upper;
      if (!std::isfinite(impulse)) continue;
      for (const double off : {0.0, -small, small})
        for (const double rate : {-2.0, -small, 0.0, small, 2.0})
          out.push_back({"", side, impulse + off, lower, upper, rate});
    }
  }
  return out;
}

inline CaseTable<SideCase> side_table() {
  CaseTable<SideCase> table{{"9.7", "the side of a bounded row"}, {"side (-1, 0 or 1)"}, {}, {}, {},
                            side_cases()};
  const auto number = [](Side side) { return Numbers{double(static_cast<signed char>(side))}; };
  judge(table, next_side, [=](auto next, const SideCase& c) {
    return number(next(c.now, c.impulse, c.lower, c.upper, c.rate));
  });
  table.right = [=](const SideCase& c) {
    if (c.now == Side::free)
      return number(c.impulse < c.lower   ? Side::lower
                    : c.impulse > c.upper ? Side::upper : Side::free);
    return number((c.now == Side::lower ? c.rate < 0 : c.rate > 0) ? Side::free : c.now);
  };
  table.tolerance = 0;
  table.in_pairs = true;
  table.given = [copy = table](const SideCase& c) { return side_given(c) + " " + copy.holds_in(); };
  return table;
}

}  // namespace joints::testing
