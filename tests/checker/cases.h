// A table of cases, for an exercise that is one function of plain arguments. Yours is compared with
// the right one, case by case, and with the result of each of the usual mistakes. A mistake is
// named where it gives your numbers in every case, so that one case that fits by chance names none.
#pragma once

#include <algorithm>
#include <initializer_list>

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
/// The numbers of a case of whatever type.
struct AnyAnswer {
  Call<Numbers(const void* c)> of;
  template <class Case>
  Numbers operator()(const Case& c) const { return of(&c); }
};
using AnyMistake = Mistake<AnyAnswer>;

/// A table whose cases have a type that it does not know: all that is compiled once.
class AnyTable {
 public:
  Subject subject;
  std::vector<std::string> entries;  ///< what the numbers of an answer are called
  double tolerance = rounding;
  bool whole = false;  ///< reports all numbers of a case, and names only what explains all cases
  bool judged = false;  ///< the mistakes are the known ones, see judge()
  bool in_pairs = false;  ///< tries every two mistakes together where none of them explains yours

  virtual ~AnyTable() = default;
  /// Every case. Fails with a report at the first one that is wrong.
  void check() const;
  /// Every case as check_numbers() and check_vectors() do, see pose_cases.h and vector_cases.h.
  void check_all_numbers() const;
  void check_all_vectors() const;
  /// "Holds in 3 of 9 cases, such as X.", for the report.
  std::string holds_in() const;
  /// Is yours right in every case?
  bool holds() const;
  /// For a test of another kind: whatever it finds wrong, the table's mistake explains it.
  std::vector<Suspect> explain(double yours, std::vector<Suspect> otherwise = {}) const;
  std::vector<VectorSuspect> explain(const vec3& yours,
                                     std::vector<VectorSuspect> otherwise = {}) const;
  /// The mistakes that give your numbers in all cases; or else what is seen in the numbers
  /// themselves; or else (unless `whole`) what explains the entries that are wrong.
  std::vector<std::string> likely() const { return likely_of({}); }

 protected:
  AnyTable(const Subject& subject, std::vector<std::string> entries)
      : subject(subject), entries(std::move(entries)) {}
  AnyTable(const AnyTable&) = default;
  AnyTable& operator=(const AnyTable&) = default;

  void check_one(const void* c, const Numbers& expected) const;
  void check_numbers_in(const void* c, const Numbers& expected, const char* beside,
                        const std::string& more) const;
  void check_vectors_in(const void* c, const Numbers& expected, double close) const;
  std::vector<std::string> likely_of(std::vector<const void*> more,
                                     const std::vector<std::size_t>& own = {}) const;
  bool same(const Numbers& a, const Numbers& b) const { return same_numbers(a, b, tolerance); }
  bool same_in_all(const Call<Numbers(const void*)>& a, const Call<Numbers(const void*)>& b) const;

  virtual std::vector<const void*> all() const = 0;
  virtual const std::string& words_of(const void* c) const = 0;
  virtual std::string given_of(const void* c) const = 0;
  virtual std::vector<std::string> entries_in(const void* c) const = 0;
  virtual Numbers yours_in(const void* c) const = 0;
  virtual Numbers right_in(const void* c) const = 0;
  virtual const std::vector<AnyMistake>& known() const = 0;
  virtual const std::vector<AnyMistake>& slips_of() const = 0;
  virtual std::vector<AnyMistake> pairs_of() const = 0;

 private:
  void check_whole(const void* c, const Numbers& numbers, const Numbers& expected) const;
  std::vector<AnyMistake> two_at_once(const std::vector<const void*>& cases) const;
  std::vector<std::string> names() const;
  std::string where_it_holds() const;
};

/// \tparam Case the arguments, and in `words` what the report calls them
template <class Case>
class CaseTable : public AnyTable {
 public:
  using Answer = Call<Numbers(const Case&)>;
  /// Mistakes may be written as functions of a case.
  class Mistakes : public std::vector<AnyMistake> {
   public:
    Mistakes() = default;
    Mistakes(std::initializer_list<Mistake<Answer>> all) {
      for (const Mistake<Answer>& one : all) push_back(one);
    }
    /// One that is tried before the others.
    void put_first(const Mistake<Answer>& one) {
      push_back(one);
      std::rotate(this->begin(), this->end() - 1, this->end());
    }
    void push_back(const Mistake<Answer>& one) {
      add(one.words, [does = one.does](const void* c) { return does(as_case(c)); });
    }
    void add(std::string words, Call<Numbers(const void* c)> does) {
      std::vector<AnyMistake>::push_back({std::move(words), {std::move(does)}});
    }
  };

  Answer yours, right;
  Mistakes mistakes;
  std::vector<Case> cases;
  Mistakes slips = {};  ///< asked where nothing else explains the numbers
  Call<Mistakes()> pairs = {};  ///< further mistakes, asked where none of those fits
  Call<std::string(const Case&)> given = {};  ///< the arguments, for the report
  /// With `whole`: what the numbers are called where each case has names of its own. Cases of
  /// different lengths are filled up with zeros.
  Call<std::vector<std::string>(const Case&)> entries_of = {};

  CaseTable(const Subject& subject, std::vector<std::string> entries, Answer yours = {},
            Answer right = {}, Mistakes mistakes = {}, std::vector<Case> cases = {})
      : AnyTable(subject, std::move(entries)), yours(yours), right(right),
        mistakes(std::move(mistakes)), cases(std::move(cases)) {}

  using AnyTable::check;
  /// One case against numbers worked out by hand. Three numbers an entry are a vector.
  void check(const Case& c, const Numbers& expected) const { check_one(&c, expected); }
  void check_numbers(const Case& c, const Numbers& expected, const char* beside,
                     const std::string& more) const {
    check_numbers_in(&c, expected, beside, more);
  }
  void check_vectors(const Case& c, const Numbers& expected, double close) const {
    check_vectors_in(&c, expected, close);
  }
  using AnyTable::likely;
  /// \param c a further case
  std::vector<std::string> likely(const Case& c) const { return likely_of({&c}); }
  /// Does one of the mistakes give the same numbers in every case?
  bool knows(const Answer& answer) const {
    const auto numbers = [&](const void* c) { return answer(as_case(c)); };
    return std::any_of(mistakes.begin(), mistakes.end(), [&](const AnyMistake& mistake) {
      return same_in_all(numbers, mistake.does.of);
    });
  }

 private:
  static const Case& as_case(const void* c) { return *static_cast<const Case*>(c); }
  std::vector<const void*> all() const override {
    std::vector<const void*> out;
    for (const Case& c : cases) out.push_back(&c);
    return out;
  }
  const std::string& words_of(const void* c) const override { return as_case(c).words; }
  std::string given_of(const void* c) const override { return given ? given(as_case(c)) : ""; }
  std::vector<std::string> entries_in(const void* c) const override {
    return entries_of ? entries_of(as_case(c)) : entries;
  }
  Numbers yours_in(const void* c) const override { return yours(as_case(c)); }
  Numbers right_in(const void* c) const override { return right(as_case(c)); }
  const std::vector<AnyMistake>& known() const override { return mistakes; }
  const std::vector<AnyMistake>& slips_of() const override { return slips; }
  std::vector<AnyMistake> pairs_of() const override {
    return pairs ? pairs() : std::vector<AnyMistake>{};
  }
};

/// Judges a function of the reader's: gives a table what is yours, and the known mistakes of the
/// subject's region. \param numbers (function, case) that a function gives in a case
template <class Function, class Case, class Measure>
void judge(CaseTable<Case>& table, Function* yours, const Measure& numbers) {
  table.yours = [=](const Case& c) { return numbers(yours, c); };
  table.judged = true;
  for (const bool slip : {false, true})
    for (const Known* one : known_of_type<Function>(table.subject.id, table.subject.region, slip))
      (slip ? table.slips : table.mistakes).add(one->words, [=](const void* c) {
        return numbers(one->as<Function>(), *static_cast<const Case*>(c));
      });
}

/// The same number as a word of a report.
inline std::string short_number(double number) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%g", number);
  return buffer;
}
/// A vector with its numbers in that form.
inline std::string in_words(const vec3& a) {
  return "(" + short_number(double(a.x)) + ", " + short_number(double(a.y)) + ", " +
         short_number(double(a.z)) + ")";
}

}  // namespace joints::testing
