// A table of cases, for an exercise that is one function of plain arguments. Yours is compared with
// the right one, case by case, and with the result of each of the usual mistakes. A mistake is
// named where it gives your numbers in every case, so that one case that fits by chance names none.
#pragma once

#include <algorithm>

#include "checker/patterns.h"
#include "tests/checker/call.h"
#include "tests/checker/check.h"
#include "tests/checker/known.h"

namespace joints::testing {

/// A mistake in words, and its effect.
template <class Function>
struct Mistake {
  std::string words;
  Function does;
};
/// A mistake as the numbers that it gives in case c.
using Asked = Mistake<Call<Numbers(std::size_t c)>>;
/// The numbers of all cases of a table, and of its mistakes.
struct CaseNumbers {
  std::vector<std::string> entries;  ///< what each number is called
  std::vector<Compared> cases;
  std::vector<Asked> mistakes;
  Call<std::vector<Asked>()> pairs;  ///< asked where none of those fits
  double tolerance;
  bool whole;  ///< names only what explains all numbers
  bool judged = false;  ///< the mistakes are the known ones
};
/// The mistakes that give your numbers in all cases; or else what is seen in the numbers
/// themselves; or else (unless `whole`) what explains the entries that are wrong, or the own ones.
std::vector<std::string> likely_mistakes(const CaseNumbers& all,
                                         const std::vector<std::size_t>& own = {});

/// \tparam Case the arguments, and in `words` what the report calls them
template <class Case>
struct CaseTable {
  using Answer = Call<Numbers(const Case&)>;
  using Mistakes = std::vector<Mistake<Answer>>;

  Subject subject;
  std::vector<std::string> entries;  ///< what the numbers of an answer are called
  Answer yours, right;
  Mistakes mistakes;
  std::vector<Case> cases;
  double tolerance = rounding;
  bool whole = false;  ///< reports all numbers of a case, and names only what explains all cases
  Call<Mistakes()> pairs = {};  ///< further mistakes, asked where none of those fits
  Call<std::string(const Case&)> given = {};  ///< the arguments, for the report
  /// With `whole`: what the numbers are called where each case has names of its own. Cases of
  /// different lengths are filled up with zeros.
  Call<std::vector<std::string>(const Case&)> entries_of = {};
  bool judged = false;  ///< the mistakes are the known ones, see judge()

  /// Every case. Fails with a report at the first one that is wrong.
  void check() const {
    for (const Case& c : cases) check(c, right(c));
  }
  /// One case against numbers worked out by hand. Three numbers an entry are a vector.
  void check(const Case& c, const Numbers& expected) const {
    const Numbers numbers = yours(c);
    if (whole) return check_whole(c, numbers, expected);
    const std::string arguments = given ? given(c) : "";
    Subject about = subject;
    about.given = arguments.c_str();
    const std::size_t width = expected.size() / entries.size();
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const std::string entry = entries[i] + (c.words.empty() ? "" : ", ") + c.words;
      std::vector<std::size_t> own;
      for (std::size_t k = i * width; k < (i + 1) * width; ++k) own.push_back(k);
      const bool wrong = std::any_of(own.begin(), own.end(), [&](std::size_t k) {
        return !same({numbers[k]}, {expected[k]});
      });
      const auto words = wrong ? likely({c}, own) : std::vector<std::string>{};
      if (width == 3)
        expect_or_say(about, entry, vector_at(numbers, i), vector_at(expected, i), tolerance,
                      words);
      else
        expect_or_say(about, entry, numbers[i], expected[i], tolerance, words);
    }
  }
  /// "Holds in 3 of 9 cases, such as X.", for the report.
  std::string holds_in() const {
    std::vector<std::string> right_ones;
    for (const Case& c : cases)
      if (same(yours(c), right(c))) right_ones.push_back(c.words);
    return "Holds in " + std::to_string(right_ones.size()) + " of " +
           std::to_string(cases.size()) + " cases" +
           (right_ones.empty() || right_ones.back().empty() ? "" : ", such as " +
                                                                       right_ones.back()) + ".";
  }
  /// Is yours right in every case?
  bool holds() const { return is_right(yours); }
  /// Does one of the mistakes give the same numbers in every case?
  bool knows(const Answer& answer) const {
    return std::any_of(mistakes.begin(), mistakes.end(), [&](const auto& mistake) {
      return std::all_of(cases.begin(), cases.end(),
                         [&](const Case& c) { return same(answer(c), mistake.does(c)); });
    });
  }
  /// Is it no mistake at all?
  bool is_right(const Answer& answer) const {
    return std::all_of(cases.begin(), cases.end(),
                       [&](const Case& c) { return same(answer(c), right(c)); });
  }
  /// For a test of another kind: whatever it finds wrong, the table's mistake explains it.
  std::vector<Suspect> explain(double yours, std::vector<Suspect> otherwise = {}) const {
    return before(suspects(yours), otherwise);
  }
  std::vector<VectorSuspect> explain(const vec3& yours,
                                     std::vector<VectorSuspect> otherwise = {}) const {
    return before(suspects(yours), otherwise);
  }
  /// Takes out the mistakes that give the right numbers in all cases: in float the small ones do.
  void leave_out_harmless() {
    std::erase_if(mistakes, [this](const auto& mistake) { return is_right(mistake.does); });
  }
  /// See likely_mistakes(). \param more further cases
  std::vector<std::string> likely(std::vector<Case> more = {},
                                  const std::vector<std::size_t>& own = {}) const {
    more.insert(more.end(), cases.begin(), cases.end());
    const auto asked = [&more](const Mistakes& among) {
      std::vector<Asked> out;
      for (const auto& [words, answer] : among)
        out.push_back({words, [&more, answer = answer](std::size_t c) { return answer(more[c]); }});
      return out;
    };
    CaseNumbers all{names(), {}, asked(mistakes), {}, tolerance, whole, judged};
    if (pairs) all.pairs = [&] { return asked(pairs()); };
    for (const Case& c : more) all.cases.push_back({yours(c), right(c)});
    return likely_mistakes(all, own);
  }

 private:
  void check_whole(const Case& c, const Numbers& numbers, const Numbers& expected) const {
    const bool right_here = same(numbers, expected);
    const std::string arguments = given && !right_here ? given(c) : "";
    Subject about = subject;
    about.given = arguments.c_str();
    expect(about, c.words, entries_of ? entries_of(c) : entries, numbers, expected, tolerance,
           right_here ? std::vector<std::string>{} : likely({c}));
  }
  /// What each number is called, where an entry is a vector, too.
  std::vector<std::string> names() const {
    const std::size_t size = right(cases[0]).size();
    if (entries.size() == size) return entries;
    std::vector<std::string> out;
    for (std::size_t i = 0; i < size; ++i)
      out.push_back(entries[i * entries.size() / size] + "." + "xyz"[i % 3]);
    return out;
  }
  bool same(const Numbers& a, const Numbers& b) const { return same_numbers(a, b, tolerance); }
  static vec3 vector_at(const Numbers& numbers, std::size_t i) {
    return {real(numbers[3 * i]), real(numbers[3 * i + 1]), real(numbers[3 * i + 2])};
  }
  template <class T>
  std::vector<SuspectOf<T>> suspects(const T& yours) const {
    std::vector<SuspectOf<T>> out;
    for (const std::string& words : likely()) out.push_back({yours, words});
    return out;
  }
  template <class T>
  static std::vector<T> before(std::vector<T> first, const std::vector<T>& then) {
    first.insert(first.end(), then.begin(), then.end());
    return first;
  }
};

/// Judges a function of the reader's: gives a table what is yours, and the known mistakes of the
/// subject's region. \param numbers (function, case) that a function gives in a case
template <class Function, class Case, class Measure>
void judge(CaseTable<Case>& table, Function* yours, const Measure& numbers) {
  table.yours = [=](const Case& c) { return numbers(yours, c); };
  table.judged = true;
  for (const auto& [words, wrong] :
       known_mistakes<Function>(table.subject.id, table.subject.region))
    table.mistakes.push_back(
        {words, [=, wrong = wrong](const Case& c) { return numbers(wrong, c); }});
}

/// The same number as a word of a report.
inline std::string short_number(double number) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%g", number);
  return buffer;
}

}  // namespace joints::testing
