// Exercise 1.5: the clamped sum of a rope, cases and the usual mistakes.
#pragma once

#include "chapters/01_distance/distance.h"
#include "engine/todo.h"
#include "tests/checker/cases.h"
#include "tests/checker/thrown.h"

namespace joints::testing {

inline const char* const told_cut_int =
    "#cut-int the fraction is cut off: an int holds whole numbers only";

struct ClampCase {
  std::string words;
  double sum, dlambda, grown;
};

inline CaseTable<ClampCase> clamp_table() {
  using C = const ClampCase&;
  // what is returned, and the new sum
  const auto right = [](C c) { return Numbers{c.grown, c.sum + c.grown}; };
  const auto grows_to = [](C c, double sum) { return Numbers{sum - c.sum, sum}; };
  const auto positive = [](double a) { return (a + std::abs(a)) / 2; };  // the part of a that is
  const auto refuses = [](C c) { return c.grown > c.dlambda; };
  const char* const each = "#clamps-each-impulse each impulse is clamped: it is the sum that must "
                           "not push";
  const char* const old_sum =
      "#new-sum-minus-itself 0 is returned: the old sum must be remembered before the new one is "
      "stored";
  const char* const too_much = "#minus-sum-that-0 if the release is larger than the sum, all of "
                               "the sum is released: minus the old sum";
  CaseTable<ClampCase> table{
      {"1.5", "the clamped sum of a rope"},
      {"returned", "new sum"},
      [](C c) {
        real sum = real(c.sum);
        const real applied = clamp_sum(real(c.dlambda), sum);
        return Numbers{double(applied), double(sum)};
      },
      right,
      {{"#nothing-clamped nothing is clamped",
        [](C c) { return Numbers{c.dlambda, c.sum + c.dlambda}; }},
       {"nothing is done", [](C c) { return Numbers{0, c.sum}; }},
       {old_sum, [=](C c) { return Numbers{0, right(c)[1]}; }},
       {each, [=](C c) { return Numbers{positive(c.dlambda), c.sum + positive(c.dlambda)}; }},
       {each, [=](C c) { return Numbers{positive(c.dlambda), positive(c.dlambda)}; }},
       {each, [=](C c) { return Numbers{positive(c.dlambda), c.sum}; }},
       {"#returns-dlambda all of dlambda is returned: return the growth of the sum",
        [=](C c) { return Numbers{c.dlambda, right(c)[1]}; }},
       {"#returns-new-sum the new sum is returned instead of its growth",
        [=](C c) { return Numbers{right(c)[1], right(c)[1]}; }},
       {"the new sum is returned instead of its growth, and it is not kept",
        [=](C c) { return Numbers{right(c)[1], c.sum}; }},
       {"#sum-not-kept the sum is not kept", [](C c) { return Numbers{c.grown, c.sum}; }},
       {"#old-minus-new the sign of the growth: new minus old",
        [=](C c) { return Numbers{-c.grown, right(c)[1]}; }},
       {"#min-for-max max and min are mixed up: the sum must not fall below 0",
        [=](C c) { return grows_to(c, refuses(c) ? c.sum + c.dlambda : 0); }},
       {"#sum-set-dlambda the sum becomes dlambda: it must grow by it",
        [=](C c) { return grows_to(c, positive(c.dlambda)); }},
       {"#sign-of-dlambda the sign of dlambda: the sum grows by it",
        [=](C c) { return grows_to(c, positive(c.sum - c.dlambda)); }},
       {"#old-sum-taken-too the sum is changed before its growth is computed, so dlambda counts "
        "twice",
        [=](C c) {
          const double sum = right(c)[1];
          return Numbers{positive(sum + c.dlambda) - sum, sum};
        }},
       {"#dlambda-twice dlambda is added twice",
        [=](C c) { return grows_to(c, right(c)[1] + c.dlambda); }},
       {too_much, [=](C c) { return refuses(c) ? Numbers{0, c.sum} : right(c); }},
       {too_much, [=](C c) { return refuses(c) ? Numbers{0, 0} : right(c); }},
       {too_much, [=](C c) { return refuses(c) ? Numbers{c.sum, 0} : right(c); }},
       {too_much, [=](C c) { return refuses(c) ? Numbers{c.sum + 2 * c.dlambda, 0} : right(c); }},
       {told_cut_int, [=](C c) {
          const double old = std::trunc(c.sum), sum = positive(old + c.dlambda);
          return Numbers{sum - old, sum};
        }},
       {told_cut_int, [=](C c) { return Numbers{std::trunc(c.grown), right(c)[1]}; }},
       {"#sum-kept-where-emptied the sum is not stored if the release is larger than it: it is 0 "
        "then",
        [=](C c) { return refuses(c) ? Numbers{-c.sum, c.sum} : right(c); }},
       {"the sum is stored only if the release is larger than it",
        [=](C c) { return refuses(c) ? right(c) : Numbers{c.dlambda, c.sum}; }},
       {"#size-sum the size of the sum is taken: below 0 it becomes 0",
        [=](C c) { return grows_to(c, std::abs(c.sum + c.dlambda)); }},
       {"dlambda must not be below minus the sum, not below the sum",
        [=](C c) { return grows_to(c, c.sum + std::max(c.dlambda, c.sum)); }},
       {"the sum has no upper bound",
        [=](C c) { return grows_to(c, std::min(right(c)[1], 1.0)); }},
       {"#small-ones-left-out a small dlambda is left out: a light body needs only a small one",
        [=](C c) { return std::abs(c.dlambda) < 1e-4 ? Numbers{0, c.sum} : right(c); }}},
      {{"sum 0 N s, dlambda 2 N s", 0, 2, 2}, {"sum 0 N s, dlambda -1 N s", 0, -1, 0},
       {"sum 3 N s, dlambda -1 N s", 3, -1, -1}, {"sum 3 N s, dlambda -5 N s", 3, -5, -3},
       {"sum 3 N s, dlambda 0.5 N s", 3, 0.5, 0.5}, {"sum 2 N s, dlambda -2 N s", 2, -2, -2},
       {"sum 5e-9 N s, dlambda 3e-9 N s", 5e-9, 3e-9, 3e-9}}};
  table.whole = true;
  table.tolerance = is_float ? rounding : 1e-13;
  return table;
}
/// Is clamp_sum written, and right by itself?
inline bool clamp_is_right() {
  bool right = false;
  return !thrown_by<NotDone>([&] { right = clamp_table().holds(); }) && right;
}

}  // namespace joints::testing
