// Exercise 1.5: the clamped sum of a rope, cases.
#pragma once

#include "chapters/01_distance/distance.h"
#include "engine/instruments/todo.h"
#include "tests/checker/cases.h"
#include "tests/checker/thrown.h"

namespace joints::testing {

struct ClampCase {
  std::string words;
  double sum, dlambda, grown;
};

inline CaseTable<ClampCase> clamp_table() {
  CaseTable<ClampCase> table{{"1.5", "the clamped sum of a rope"}, {"returned", "new sum"}};
  judge(table, clamp_sum, [](auto clamp_sum, const ClampCase& c) {
    real sum = real(c.sum);
    const real applied = clamp_sum(real(c.dlambda), sum);
    return Numbers{double(applied), double(sum)};
  });
  table.right = [](const ClampCase& c) { return Numbers{c.grown, c.sum + c.grown}; };
  table.cases = {
      {"sum 0 N s, dlambda 2 N s", 0, 2, 2}, {"sum 0 N s, dlambda -1 N s", 0, -1, 0},
      {"sum 3 N s, dlambda -1 N s", 3, -1, -1}, {"sum 3 N s, dlambda -5 N s", 3, -5, -3},
      {"sum 3 N s, dlambda 0.5 N s", 3, 0.5, 0.5}, {"sum 2 N s, dlambda -2 N s", 2, -2, -2},
      {"sum 5e-9 N s, dlambda 3e-9 N s", 5e-9, 3e-9, 3e-9}};
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
