// A table of cases that are looked at as a whole, for an exercise that changes many numbers. A
// report shows all numbers of a case that are wrong, and a mistake is named only where it gives all
// of yours, in all cases.
#pragma once

#include <algorithm>

#include "tests/checker/report.h"

namespace joints::testing {

/// \tparam Case the arguments, and in `words` what the report calls them
template <class Case>
struct WholeTable {
  using Answer = std::function<Numbers(const Case&)>;

  Subject subject;
  std::vector<std::string> entries;  ///< what the numbers of an answer are called
  Answer yours, right;
  std::vector<std::pair<std::string, Answer>> mistakes;
  std::vector<Case> cases;
  double tolerance = rounding;

  /// Every case. Fails with a report at the first one that is wrong.
  void check() const {
    for (const Case& c : cases) check(c, right(c));
  }
  /// One case against numbers worked out by hand.
  void check(const Case& c, const Numbers& expected) const {
    const Numbers numbers = yours(c);
    if (close(numbers, expected, tolerance)) return testing::check(subject, "");
    Table table("expected");
    for (std::size_t i = 0; i < expected.size(); ++i)
      if (!near(numbers[i], expected[i], tolerance))
        table.entry(entries[i], numbers[i], expected[i], tolerance);
    const std::string mistake = named(c, numbers);
    fail(subject, "Case: " + c.words + ".\n\n" + table.words() +
                      (mistake.empty() ? "" : "\n" + testing::likely(mistake)));
  }
  /// Is yours right in every case?
  bool holds() const { return fits(right); }

 private:
  std::string named(const Case& c, const Numbers& numbers) const {
    for (const auto& [words, answer] : mistakes)
      if (same(numbers, answer(c)) && fits(answer)) return words;
    return no_number(numbers);
  }
  bool fits(const Answer& answer) const {
    return std::all_of(cases.begin(), cases.end(),
                       [&](const Case& c) { return same(yours(c), answer(c)); });
  }
  bool same(const Numbers& a, const Numbers& b) const {
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a[i] != b[i] && !(std::isnan(a[i]) && std::isnan(b[i])) && !near(a[i], b[i], tolerance))
        return false;
    return true;
  }
};

}  // namespace joints::testing
