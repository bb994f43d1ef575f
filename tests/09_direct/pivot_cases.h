// Exercise 9.4: the inverse of a pivot as a table, with the usual mistakes.
#pragma once

#include "chapters/09_direct/direct.h"
#include "tests/checker/arguments.h"

namespace joints::testing {

inline const char* const told_bound_own =
    "#bound-own a fixed bound for masses of any size: it is a fraction of the original entry";
inline const char* const told_comparison_turned_round =
    "#comparison-turned-round the comparison is reversed: a pivot of at most the fraction gets 0";
inline const char* const told_size_pivot =
    "#size-pivot the size of the pivot is compared: a pivot below zero is an error, too, and "
    "gets 0";

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
  // numbers of all sizes: what is compared is the inverse in units of 1/pivot
  const auto scaled = [](auto inverse) {
    return [=](const Case& c) {
      const double scale = c.pivot != 0 && std::isfinite(c.pivot) ? std::abs(c.pivot) : 1;
      return Numbers{scale * inverse(c)};
    };
  };
  const double share = is_float ? 1e-7 : 1e-11;
  const char* const least = "#least-one-bound a bound that does not become smaller with the entry: "
                            "it is a fraction of the entry, however small";
  const auto unless = [=](auto dropped) {
    return scaled([=](const Case& c) { return dropped(c) ? 0 : 1 / c.pivot; });
  };
  CaseTable<Case> table{{"9.4", "1 / pivot, and 0 for a dependent row"},
                        {"inverse times |pivot|"}, {}, {}, {}, pivot_cases()};
  table.tolerance = 1e-12;
  table.whole = true;
  table.yours = scaled([](const Case& c) { return inverse_pivot(c.pivot, c.original); });
  table.right = unless([=](const Case& c) { return !(c.pivot > share * c.original); });
  table.mistakes = {
      {"#every-pivot-inverted every pivot is inverted: that of a dependent row is a rounding "
       "error, it gets 0",
       unless([](const Case&) { return false; })},
      {"#only-exactly-zero only a pivot of exactly 0 gets 0: rounding error is never that",
       unless([](const Case& c) { return c.pivot == 0; })},
      {"#above-zero only a pivot of 0 or below gets 0: a rounding error may be positive",
       unless([](const Case& c) { return !(c.pivot > 0); })},
      {"#whole-entry always 0: a pivot above its fraction of the original entry has an inverse",
       unless([](const Case&) { return true; })},
      {told_comparison_turned_round,
       unless([=](const Case& c) { return c.pivot > share * c.original; })},
      {told_comparison_turned_round,
       unless([=](const Case& c) { return c.pivot >= share * c.original; })},
      {told_comparison_turned_round,
       unless([=](const Case& c) { return !(c.pivot < share * c.original); })},
      {told_comparison_turned_round,
       unless([=](const Case& c) { return !(c.pivot <= share * c.original); })},
      {"#infinite-dependent-row a dependent row gets an infinite inverse: it gets 0, no impulse",
       scaled([=](const Case& c) {
         return c.pivot > share * c.original ? 1 / c.pivot
                                             : std::numeric_limits<double>::infinity();
       })},
      {"#regularised a fraction of the entry is added to every pivot: that changes all impulses. "
       "Compare, and return 0",
       scaled([=](const Case& c) { return 1 / (c.pivot + share * c.original); })},
      {"#greater-both a pivot is raised to its fraction of the entry: a smaller one gets 0, no "
       "impulse",
       scaled([=](const Case& c) { return 1 / std::max(c.pivot, share * c.original); })},
      {least,
       unless([=](const Case& c) { return !(c.pivot > share * std::max(c.original, 1.0)); })},
      {"#equality-inverted where both are zero there is no inverse: > and not >=",
       unless([=](const Case& c) { return !(c.pivot >= share * c.original); })},
      {"#below-share-alone two zeros, or values that are not numbers, get an inverse: test pivot > "
       "fraction of the entry, which is false then",
       unless([=](const Case& c) { return c.pivot < share * c.original; })},
      {"#not-number-gets-through a pivot or entry that is not a number gets through: test pivot > "
       "fraction of the entry, which is false then",
       unless([=](const Case& c) { return c.pivot <= share * c.original; })},
      {told_size_pivot,
       unless([=](const Case& c) { return !(std::abs(c.pivot) > share * c.original); })},
      {told_size_pivot,
       unless([=](const Case& c) { return std::abs(c.pivot) <= share * c.original; })},
      {"#size-pivot-inverted the size of the pivot is inverted: a pivot below zero gets 0",
       scaled([=](const Case& c) {
         return std::abs(c.pivot) > share * c.original ? 1 / std::abs(c.pivot) : 0;
       })},
      {"#original-inverted the original entry is inverted: it serves only for the comparison",
       scaled([=](const Case& c) {
         return c.pivot > share * c.original ? 1 / c.original : 0;
       })},
      {"#pivot-returned the pivot is returned: its inverse",
       scaled([=](const Case& c) { return c.pivot > share * c.original ? c.pivot : 0; })},
      {"#sign the sign", scaled([=](const Case& c) {
         return c.pivot > share * c.original ? -1 / c.pivot : 0;
       })},
      {"the pivot is divided by its entry: 1 over the pivot",
       scaled([=](const Case& c) {
         return c.pivot > share * c.original ? c.original / c.pivot : 0;
       })},
      {"#original-for-dependent a dependent row gets 1 over its original entry: it gets 0, no "
       "impulse",
       scaled([=](const Case& c) {
         return 1 / (c.pivot > share * c.original ? c.pivot : c.original);
       })},
      {"#one-dependent-row a dependent row gets 1: it gets 0, no impulse",
       scaled([=](const Case& c) { return c.pivot > share * c.original ? 1 / c.pivot : 1; })},
      {"the pivot is compared with the whole entry: elimination only makes it smaller",
       unless([](const Case& c) { return !(c.pivot >= c.original); })},
      {"the pivot is compared with the whole entry: elimination only makes it smaller",
       unless([](const Case& c) { return !(c.pivot > c.original); })},
      {"#pivot-entry-exchanged pivot and entry are exchanged in the comparison",
       unless([=](const Case& c) { return !(c.original > share * c.pivot); })},
      {"the entry is divided by the fraction: they are multiplied",
       unless([=](const Case& c) { return !(c.pivot > c.original / share); })},
      {"#inverse-int 1 / pivot is cut to a whole number: an int has no fraction",
       scaled([=](const Case& c) {
         const double inverse = c.pivot > share * c.original ? std::trunc(1 / c.pivot) : 0;
         return std::abs(inverse) < 2147483648.0 ? inverse : -2147483648.0;  // what an int holds
       })}};
  for (const double bound : {1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15,
                             1e-16, 2.220446049250313e-16, 1e-20}) {
    table.mistakes.push_back({told_bound_own,
                              unless([=](const Case& c) { return !(c.pivot > bound); })});
    table.mistakes.push_back({told_bound_own,
                              unless([=](const Case& c) { return c.pivot < bound; })});
    table.mistakes.push_back({told_bound_own,
                              unless([=](const Case& c) { return std::abs(c.pivot) < bound; })});
    table.mistakes.push_back({told_bound_own,
                              unless([=](const Case& c) { return !(std::abs(c.pivot) > bound); })});
    table.mistakes.push_back({least,
                              unless([=](const Case& c) {
                                return !(c.pivot > std::max(share * c.original, bound));
                              })});
    table.mistakes.push_back({bound < share ? "#fraction-small the fraction is too small: rounding "
                                              "errors are larger"
                                            : "#fraction-large the fraction is too large: a row "
                                              "that is needed gets no impulse",
                              unless([=](const Case& c) {
                                return !(c.pivot > bound * c.original);
                              })});
  }
  table.leave_out_harmless();
  table.given = [](const Case& c) { return "Given: " + arguments_of(c, pivot_arguments) + "."; };
  add_formulas(table, pivot_arguments);
  table.given = [copy = table](const Case& c) { return copy.given(c) + " " + copy.holds_in(); };
  return table;
}

}  // namespace joints::testing
