// A table of cases, for an exercise that is one function of plain arguments. Yours is compared with
// what is right, case by case, and with what each of the usual mistakes would give. A mistake is
// named where it gives your numbers in every case, so that one case that fits by chance names none.
#pragma once

#include <algorithm>

#include "tests/checker/patterns.h"

namespace joints::testing {

/// \tparam Case the arguments, and in `words` what the report calls them
template <class Case>
struct CaseTable {
  using Answer = std::function<Numbers(const Case&)>;
  using Mistakes = std::vector<std::pair<std::string, Answer>>;

  Subject subject;
  std::vector<std::string> entries;  ///< what the numbers of an answer are called
  Answer yours, right;
  Mistakes mistakes;
  std::vector<Case> cases;
  double tolerance = rounding;
  bool whole = false;  ///< reports all numbers of a case, and names only what explains all cases
  std::function<Mistakes()> pairs = {};  ///< further mistakes, asked where none of those fits
  std::function<std::string(const Case&)> given = {};  ///< the arguments, for the report

  /// Every case. Fails with a report at the first one that is wrong.
  void check() const {
    for (const Case& c : cases) check(c, right(c));
  }
  /// One case against numbers worked out by hand.
  void check(const Case& c, const Numbers& expected) const {
    const Numbers numbers = yours(c);
    const std::string arguments = given ? given(c) : "";
    Subject about = subject;
    about.given = arguments.c_str();
    if (whole) {
      const bool right_here = same(numbers, expected);
      expect(about, c.words, entries, numbers, expected, tolerance,
             right_here ? std::vector<std::string>{} : likely({c}));
      return;
    }
    for (std::size_t i = 0; i < expected.size(); ++i) {
      std::vector<Suspect> suspects;
      if (!same({numbers[i]}, {expected[i]}))
        for (const std::string& words : likely({c})) suspects.push_back({numbers[i], words});
      expect(about, entries[i] + (c.words.empty() ? "" : ", ") + c.words, numbers[i], expected[i],
             tolerance, suspects);
    }
  }
  /// Is yours right in every case?
  bool holds() const { return is_right(yours); }
  /// Does one of the mistakes give the same numbers in every case?
  bool knows(const Answer& answer) const {
    return std::any_of(mistakes.begin(), mistakes.end(), [&](const auto& mistake) {
      return std::all_of(cases.begin(), cases.end(),
                         [&](const Case& c) { return same(answer(c), mistake.second(c)); });
    });
  }
  /// Is it no mistake at all?
  bool is_right(const Answer& answer) const {
    return std::all_of(cases.begin(), cases.end(),
                       [&](const Case& c) { return same(answer(c), right(c)); });
  }
  /// For a test of another kind: whatever number it finds wrong, the table's mistake explains it.
  std::vector<Suspect> explain(double number, std::vector<Suspect> otherwise = {}) const {
    std::vector<Suspect> out;
    for (const std::string& words : likely()) out.push_back({number, words});
    out.insert(out.end(), otherwise.begin(), otherwise.end());
    return out;
  }
  /// The mistakes that give your numbers in all cases, or else what these have in common, or else
  /// (unless `whole`) the mistakes that give them wherever yours are wrong.
  /// \param more further cases
  std::vector<std::string> likely(std::vector<Case> more = {}) const {
    more.insert(more.end(), cases.begin(), cases.end());
    std::vector<Compared> all;
    std::vector<bool> wrong;
    for (const Case& c : more) {
      all.push_back({yours(c), right(c)});
      wrong.push_back(!same(all.back().yours, all.back().right));
    }
    const auto count = std::count(wrong.begin(), wrong.end(), true);
    std::vector<std::string> out;
    if (count == 0) return out;
    const auto look = [&](const Mistakes& among, bool everywhere, const std::string& after) {
      for (const auto& [words, answer] : among) {
        bool fits = true;
        for (std::size_t i = 0; fits && i < more.size(); ++i)
          if (everywhere || wrong[i]) fits = same(all[i].yours, answer(more[i]));
        if (fits) out.push_back(words + after);
      }
    };
    const auto pattern = [&](bool whole) {
      const std::string words = common_pattern(names(), all, tolerance, whole);
      if (!words.empty()) out.push_back(words);
    };
    look(mistakes, true, "");
    if (out.empty()) pattern(true);
    if (out.empty() && pairs) look(pairs(), true, "");
    if (out.empty()) pattern(false);
    if (out.empty() && !whole) {
      look(mistakes, false, " (in the " + std::to_string(count) + " of " +
                                std::to_string(more.size()) + " cases that are wrong)");
      if (std::adjacent_find(out.begin(), out.end(), std::not_equal_to<>()) != out.end())
        out.clear();  // where several fit, the cases do not tell which
    }
    return out;
  }

 private:
  /// What each number is called, where an entry is a vector, too.
  std::vector<std::string> names() const {
    const std::size_t size = right(cases[0]).size();
    if (entries.size() == size) return entries;
    std::vector<std::string> out;
    for (std::size_t i = 0; i < size; ++i)
      out.push_back(entries[i * entries.size() / size] + "." + "xyz"[i % 3]);
    return out;
  }
  bool same(const Numbers& a, const Numbers& b) const {
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a[i] != b[i] && !(std::isnan(a[i]) && std::isnan(b[i])) &&  // infinite ones agree
          !close({a[i]}, {b[i]}, tolerance))
        return false;
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
