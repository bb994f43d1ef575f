// A table of cases, for an exercise that is one function of plain arguments. Yours is compared with
// what is right, case by case, and with what each of the usual mistakes would give. A mistake is
// named where it gives your numbers in every case, so that one case that fits by chance names none.
#pragma once

#include "tests/checker/check.h"

namespace joints::testing {

/// \tparam Case the arguments, and in `words` what the report calls them
template <class Case>
struct CaseTable {
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
    for (std::size_t i = 0; i < expected.size(); ++i) {
      std::vector<Suspect> suspects;
      if (!same({numbers[i]}, {expected[i]}))
        for (const std::string& words : likely({c})) suspects.push_back({numbers[i], words});
      expect(subject, entries[i] + (c.words.empty() ? "" : ", ") + c.words, numbers[i],
             expected[i], tolerance, suspects);
    }
  }
  /// For a test of another kind: whatever number it finds wrong, the table's mistake explains it.
  std::vector<Suspect> explain(double number, std::vector<Suspect> otherwise = {}) const {
    std::vector<Suspect> out;
    for (const std::string& words : likely()) out.push_back({number, words});
    out.insert(out.end(), otherwise.begin(), otherwise.end());
    return out;
  }
  /// The mistakes that give your numbers in all cases, then those that do so wherever yours are
  /// wrong, since there may be two mistakes. \param more further cases
  std::vector<std::string> likely(std::vector<Case> more = {}) const {
    more.insert(more.end(), cases.begin(), cases.end());
    std::vector<Numbers> mine, expected;
    bool all_right = true;
    for (const Case& c : more) {
      mine.push_back(yours(c));
      expected.push_back(right(c));
      all_right = all_right && same(mine.back(), expected.back());
    }
    std::vector<std::string> out;
    for (const bool everywhere : {true, false})
      for (const auto& [words, answer] : mistakes) {
        bool fits = !all_right;
        for (std::size_t i = 0; fits && i < more.size(); ++i)
          if (everywhere || !same(mine[i], expected[i])) fits = same(mine[i], answer(more[i]));
        if (fits) out.push_back(words);
      }
    return out;
  }

 private:
  bool same(const Numbers& a, const Numbers& b) const {
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a[i] != b[i] && !close({a[i]}, {b[i]}, tolerance)) return false;  // infinite ones agree
    return true;
  }
};

/// The same number as a word of a report.
inline std::string short_number(double number) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%g", number);
  return buffer;
}

}  // namespace joints::testing
