#include "tests/checker/cases.h"

#include <algorithm>
#include <map>
#include <memory>
#include <numbers>

#include "checker/report.h"

namespace joints::testing {

namespace {

// A mistake as the numbers that it gives in case c.
using Asked = Mistake<Call<Numbers(std::size_t c)>>;
// The numbers of all cases of a table, and of its mistakes.
struct CaseNumbers {
  std::vector<std::string> entries;  // what each number is called
  std::vector<Compared> cases;
  std::vector<Asked> mistakes;
  Call<std::vector<Asked>()> pairs;  // asked where none of those fits
  std::vector<Asked> slips;          // asked at last
  double tolerance;
  bool whole;  // names only what explains all numbers
  bool judged;  // the mistakes are the known ones
};

// Some of the numbers of every case.
using Columns = std::vector<std::size_t>;
Numbers at(const Numbers& numbers, const Columns& columns) {
  Numbers out;
  for (const std::size_t i : columns) out.push_back(numbers[i]);
  return out;
}

std::vector<std::string> named(const CaseNumbers& all, const std::vector<Asked>& mistakes,
                               const Columns& columns) {
  std::vector<std::string> out;
  // Yes or no in one entry fits too easily: there a mistake must leave the other entries right.
  const bool only_yes_or_no = columns.size() < all.entries.size() &&
                              std::all_of(all.cases.begin(), all.cases.end(), [&](const auto& c) {
                                const Numbers numbers = at(c.right, columns);
                                return std::all_of(numbers.begin(), numbers.end(),
                                                   [](double a) { return a == 0 || a == 1; });
                              });
  for (const Asked& mistake : mistakes) {
    bool fits = true;
    for (std::size_t c = 0; fits && c < all.cases.size(); ++c) {
      Numbers wrong = mistake.does(c);
      const Numbers own = at(wrong, columns);
      fits = same_numbers(at(all.cases[c].yours, columns), own, all.tolerance);
      if (!only_yes_or_no) continue;
      for (const std::size_t k : columns) wrong[k] = all.cases[c].right[k];
      fits = fits && same_numbers(wrong, all.cases[c].right, all.tolerance);
    }
    if (fits) out.push_back(mistake.words);
  }
  return out;
}

// ---- what is seen in the numbers themselves -----------------------------------------------------

// Is every number of yours f(the right one)? Some must be others than the right ones, and not 0.
template <class F>
bool is(const std::vector<Numbers>& yours, const std::vector<Numbers>& right, double tolerance,
        F f) {
  int changed = 0, not_zero = 0;
  for (std::size_t c = 0; c < yours.size(); ++c)
    for (std::size_t i = 0; i < yours[c].size(); ++i) {
      const double wanted = f(right[c][i]);
      if (!same_numbers({yours[c][i]}, {wanted}, tolerance)) return false;
      changed += !same_numbers({wanted}, {right[c][i]}, tolerance);
      not_zero += !near(wanted, 0, tolerance);
    }
  return changed > 2 && not_zero > 0;
}

std::string constant(const std::vector<Numbers>& yours, const std::vector<Numbers>& right,
                     double tolerance) {
  int different = 0;
  for (std::size_t c = 0; c < yours.size(); ++c) {
    if (!same_numbers(yours[c], Numbers(yours[c].size(), yours[0][0]), tolerance)) return "";
    different += !same_numbers(right[c], right[0], tolerance);
  }
  if (different < 2) return "";
  return short_number(yours[0][0]) + " in every case: is it computed from the arguments? Was it "
                                     "cut off by an int, or does it use a variable that was never "
                                     "set?";
}

// Does only what is small differ, and is it 0?
bool threshold(const std::vector<Numbers>& yours, const std::vector<Numbers>& right,
               double tolerance) {
  double largest_wrong = 0, smallest_right = std::numeric_limits<double>::infinity();
  int wrong = 0;
  for (std::size_t c = 0; c < yours.size(); ++c)
    for (std::size_t i = 0; i < yours[c].size(); ++i) {
      const double a = std::abs(right[c][i]);
      const bool same = same_numbers({yours[c][i]}, {right[c][i]}, tolerance);
      if (!same && yours[c][i] != 0) return false;
      wrong += !same;
      if (!same) largest_wrong = std::max(largest_wrong, a);
      else if (a > tolerance) smallest_right = std::min(smallest_right, a);
    }
  return 0 < largest_wrong && largest_wrong < smallest_right / (wrong < 4 ? 2 : 1);
}

std::string shown(const CaseNumbers& all, const Columns& columns) {
  std::vector<Numbers> yours, right, first, last, overwritten;
  for (const Compared& c : all.cases) {
    yours.push_back(at(c.yours, columns));
    right.push_back(at(c.right, columns));
    first.emplace_back(columns.size(), right.back().front());
    last.emplace_back(columns.size(), right.back().back());
    overwritten.push_back({right.back().back(), 0});
  }
  if (const std::string words = constant(yours, right, all.tolerance); !words.empty())
    return words;
  const auto equal = [&](const std::vector<Numbers>& numbers) {
    bool fits = columns.size() == 2;
    for (std::size_t c = 0; c < yours.size(); ++c)
      fits = fits && same_numbers(yours[c], numbers[c], all.tolerance);
    return fits;
  };
  if (equal(overwritten)) return "#written-twice the first number is written twice, the second "
                                 "never";
  if (equal(first)) return "#b-twice the first number stands in both places";
  if (equal(last)) return "the second number stands in both places";
  if (threshold(yours, right, all.tolerance))
    return "#threshold small values have become 0: no threshold belongs here";
  const auto fits = [&](auto f) { return is(yours, right, all.tolerance, f); };
  if (fits([](double a) { return std::abs(a); }))
    return "#absolute-values an absolute value: the sign is lost";
  if (fits([](double a) { return std::max(a, 0.0); }))
    return "#max-0 negative values have become 0";
  if (fits([](double a) { return std::trunc(a); }))
    return "#cut-int the fraction is cut off: an int holds whole numbers only";
  if (fits([](double a) { return 1 / a; })) return "one over the right number";
  const double degrees = 180 / std::numbers::pi;
  if (fits([=](double a) { return degrees * a; })) return "degrees where radians belong";
  if (fits([=](double a) { return a / degrees; }))
    return "a factor of pi/180: the angles are in radians already";
  return "";
}

// See AnyTable::likely().
std::vector<std::string> likely_mistakes(const CaseNumbers& all, const Columns& own) {
  const std::size_t n = all.entries.size();
  Columns every, wrong;
  for (const Compared& c : all.cases)
    if (c.yours.size() != n || c.right.size() != n) return {};
  for (std::size_t i = 0; i < n; ++i) {
    every.push_back(i);
    if (std::any_of(all.cases.begin(), all.cases.end(), [&](const Compared& c) {
          return !same_numbers({c.yours[i]}, {c.right[i]}, all.tolerance);
        }))
      wrong.push_back(i);
  }
  if (wrong.empty()) return {};
  const auto pattern = [&](bool whole) {
    return common_pattern(all.entries, all.cases, all.tolerance, whole);
  };
  if (const auto words = named(all, all.mistakes, every); !words.empty()) return words;
  for (const std::string& words : {shown(all, every), pattern(true)})
    if (!words.empty()) return {words};
  if (all.pairs)
    if (const auto words = named(all, all.pairs(), every); !words.empty()) return words;
  // A known mistake in some of the numbers is seldom meant where a pattern explains all of them.
  if (all.judged)
    if (const std::string words = pattern(false); !words.empty()) return {words};
  for (const Columns& columns : {wrong, own}) {
    if (all.whole || columns.empty() || columns.size() == n) continue;
    std::vector<std::string> names, found = named(all, all.mistakes, columns);
    for (const std::size_t i : columns) names.push_back(all.entries[i]);
    if (const std::string words = found.empty() ? shown(all, columns) : ""; !words.empty())
      found.push_back(words);
    for (std::string& words : found) words = "in " + listed(names) + " alone: " + words;
    if (!found.empty()) return found;
  }
  if (const std::string words = pattern(false); !words.empty()) return {words};
  const bool numbers = std::all_of(all.cases.begin(), all.cases.end(),
                                   [](const Compared& c) { return no_number(c.yours).empty(); });
  return numbers ? named(all, all.slips, every) : std::vector<std::string>{};
}

vec3 vector_at(const Numbers& numbers, std::size_t i) {
  return {real(numbers[3 * i]), real(numbers[3 * i + 1]), real(numbers[3 * i + 2])};
}
template <class T>
std::vector<SuspectOf<T>> before(const std::vector<std::string>& likely, const T& yours,
                                 const std::vector<SuspectOf<T>>& then) {
  std::vector<SuspectOf<T>> out;
  for (const std::string& words : likely) out.push_back({yours, words});
  out.insert(out.end(), then.begin(), then.end());
  return out;
}

}  // namespace

void AnyTable::check() const {
  for (const void* c : all()) check_one(c, right_in(c));
}
void AnyTable::check_one(const void* c, const Numbers& expected) const {
  const Numbers numbers = yours_in(c);
  if (whole) return check_whole(c, numbers, expected);
  const std::string arguments = given_of(c), &words = words_of(c);
  Subject about = subject;
  about.given = arguments.c_str();
  const std::size_t width = expected.size() / entries.size();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string entry = entries[i] + (words.empty() ? "" : ", ") + words;
    Columns own;
    for (std::size_t k = i * width; k < (i + 1) * width; ++k) own.push_back(k);
    const auto likely = same(at(numbers, own), at(expected, own)) ? std::vector<std::string>{}
                                                                  : likely_of({c}, own);
    if (width == 3)
      expect_or_say(about, entry, vector_at(numbers, i), vector_at(expected, i), tolerance, likely);
    else expect_or_say(about, entry, numbers[i], expected[i], tolerance, likely);
  }
}
void AnyTable::check_whole(const void* c, const Numbers& numbers, const Numbers& expected) const {
  const bool right_here = same(numbers, expected);
  const std::string arguments = right_here ? "" : given_of(c);
  Subject about = subject;
  about.given = arguments.c_str();
  expect(about, words_of(c), entries_in(c), numbers, expected, tolerance,
         right_here ? std::vector<std::string>{} : likely_of({c}));
}
// One number after another, with the poses at which the table holds.
void AnyTable::check_numbers_in(const void* c, const Numbers& expected, const char* beside,
                                const std::string& more) const {
  const Numbers yours = yours_in(c);
  if (close(yours, expected, tolerance)) return testing::check(subject, "");
  Table numbers(beside);
  for (std::size_t i = 0; i < expected.size(); ++i)
    if (!near(yours[i], expected[i], tolerance))
      numbers.entry(entries[i], yours[i], expected[i], tolerance);
  const std::vector<std::string> mistakes = likely_of({c});
  std::string words = no_number(yours);
  if (words.empty() && !mistakes.empty()) words = mistakes.front();
  fail(subject, "Pose: " + words_of(c) + ".\n\n" + numbers.words() + more + "\n" +
                    where_it_holds() +
                    (words.empty() ? "None of the usual mistakes explains it: compare it with the "
                                     "equation, entry by entry.\n"
                                   : testing::likely(words)));
}
void AnyTable::check_all_numbers() const {
  for (const void* c : all()) check_numbers_in(c, right_in(c), "numeric ", "");
}
// At which poses the numbers are wrong, and at which others all are right.
std::string AnyTable::where_it_holds() const {
  std::vector<std::string> fails, holds;
  const auto add = [](std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const void* c : all())
    add(close(yours_in(c), right_in(c), tolerance) ? holds : fails, words_of(c));
  std::erase_if(holds, [&](const std::string& pose) {
    return std::find(fails.begin(), fails.end(), pose) != fails.end();
  });
  return fails.empty()   ? "Holds at all other poses.\n"
         : holds.empty() ? "Fails at " + joined(fails) + ".\n"
                         : "Fails at " + joined(fails) + "; holds at " + joined(holds) + ".\n";
}
void AnyTable::check_vectors_in(const void* c, const Numbers& expected, double closely) const {
  const Numbers numbers = yours_in(c);
  std::vector<std::string> likely;
  if (!close(numbers, expected, closely)) likely = likely_of({c});
  const std::string arguments = given_of(c);
  Subject about = subject;
  about.given = arguments.c_str();
  for (std::size_t k = 0; k < entries.size(); ++k)
    expect(about, entries[k] + " (" + words_of(c) + ")", vector_at(numbers, k),
           vector_at(expected, k), closely, before(likely, vector_at(numbers, k), {}));
}
void AnyTable::check_all_vectors() const {
  for (const void* c : all()) check_vectors_in(c, right_in(c), tolerance);
}
std::string AnyTable::holds_in() const {
  std::vector<std::string> right_ones;
  const auto cases = all();
  for (const void* c : cases)
    if (same(yours_in(c), right_in(c))) right_ones.push_back(words_of(c));
  return "Holds in " + std::to_string(right_ones.size()) + " of " + std::to_string(cases.size()) +
         " cases" +
         (right_ones.empty() || right_ones.back().empty() ? "" : ", such as " + right_ones.back()) +
         ".";
}
bool AnyTable::holds() const {
  return same_in_all([this](const void* c) { return yours_in(c); },
                     [this](const void* c) { return right_in(c); });
}
bool AnyTable::same_in_all(const Call<Numbers(const void*)>& a,
                           const Call<Numbers(const void*)>& b) const {
  const auto cases = all();
  return std::all_of(cases.begin(), cases.end(),
                     [&](const void* c) { return same(a(c), b(c)); });
}
std::vector<Suspect> AnyTable::explain(double yours, std::vector<Suspect> otherwise) const {
  return before(likely(), yours, otherwise);
}
std::vector<VectorSuspect> AnyTable::explain(const vec3& yours,
                                             std::vector<VectorSuspect> otherwise) const {
  return before(likely(), yours, otherwise);
}
std::vector<std::string> AnyTable::likely_of(std::vector<const void*> more,
                                             const Columns& own) const {
  for (const void* c : all()) more.push_back(c);
  const auto asked = [&more](const std::vector<AnyMistake>& among) {
    std::vector<Asked> out;
    for (const auto& [words, answer] : among)
      out.push_back({words, [&more, of = answer.of](std::size_t c) { return of(more[c]); }});
    return out;
  };
  CaseNumbers numbers{names(), {}, asked(known()),
                      [&] {
                        std::vector<AnyMistake> all;
                        if (in_pairs) all = two_at_once(more);
                        for (AnyMistake& one : pairs_of()) all.push_back(std::move(one));
                        return asked(all);
                      },
                      asked(slips_of()), tolerance, whole, judged};
  for (const void* c : more) numbers.cases.push_back({yours_in(c), right_in(c)});
  return likely_mistakes(numbers, own);
}
// Every two of the mistakes. Where both change a number it is 0 if one of them makes it 0, such as
// a guard does, and a sum with both differences if not.
std::vector<AnyMistake> AnyTable::two_at_once(const std::vector<const void*>& cases) const {
  const std::vector<AnyMistake>& mistakes = known();
  using Kept = std::map<const void*, Numbers>;
  std::vector<std::shared_ptr<Kept>> of;
  const auto right = std::make_shared<Kept>();
  for (const void* c : cases) (*right)[c] = right_in(c);
  for (const AnyMistake& mistake : mistakes) {
    of.push_back(std::make_shared<Kept>());
    for (const void* c : cases) (*of.back())[c] = mistake.does.of(c);
  }
  const auto both = [tolerance = tolerance](double a, double b, double right) {
    if (near(a, right, tolerance)) return b;
    if (near(b, right, tolerance)) return a;
    return a == 0 || b == 0 ? 0 : a + b - right;
  };
  std::vector<AnyMistake> out;
  for (std::size_t i = 0; i < mistakes.size(); ++i)
    for (std::size_t j = i + 1; j < mistakes.size(); ++j)
      out.push_back({mistakes[i].words + "; and " + mistakes[j].words,
                     {[=, one = of[i], other = of[j]](const void* c) {
                       Numbers numbers = right->at(c);
                       for (std::size_t k = 0; k < numbers.size(); ++k)
                         numbers[k] = both((*one)[c][k], (*other)[c][k], numbers[k]);
                       return numbers;
                     }}});
  return out;
}
// What each number is called, where an entry is a vector, too.
std::vector<std::string> AnyTable::names() const {
  const std::size_t size = right_in(all()[0]).size();
  if (entries.size() == size) return entries;
  std::vector<std::string> out;
  for (std::size_t i = 0; i < size; ++i)
    out.push_back(entries[i * entries.size() / size] + "." + "xyz"[i % 3]);
  return out;
}

}  // namespace joints::testing
