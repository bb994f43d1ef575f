// Exercise 5.2, does a weld break, as a table of cases.
#pragma once

#include "chapters/05_fixed/fixed.h"
#include "tests/checker/cases.h"

namespace joints::testing {

struct BreakCase {
  std::string words;
  vec3 force, torque;
  Strength strength{10, 2};
};

inline CaseTable<BreakCase> break_table() {
  CaseTable<BreakCase> table{{"5.2", "does a weld break? (1 yes, 0 no)", 3}, {"breaks"},
                             {}, {}, {}, {}};
  judge(table, breaks, [](auto breaks, const BreakCase& c) {
    return Numbers{breaks({c.force, c.torque}, c.strength) ? 1.0 : 0.0};
  });
  table.right = [](const BreakCase& c) {
    const auto over = [](const vec3& a, real bound) { return dot(a, a) > bound * bound; };
    const auto& [force, torque] = c.strength;
    return Numbers{over(c.force, force) || over(c.torque, torque) ? 1.0 : 0.0};
  };
  table.cases = {
      {"12 N of 10, 0 N m of 2", vec3(0, 12, 0), vec3(0)},
      {"0 N of 10, 3 N m of 2", vec3(0), vec3(0, 0, 3)},
      {"12 N of 10 downwards", vec3(0, 0, -12), vec3(0)},
      {"3 N m of 2 the other way round", vec3(0), vec3(-3, 0, 0)},
      {"13.9 N of 10, askew", vec3(8, 8, 8), vec3(0)},
      {"2.3 N m of 2, askew", vec3(0), vec3(real(1.5), real(-1.5), 1)},
      {"12 N of 10, 3 N m of 2", vec3(12, 0, 0), vec3(0, 3, 0)},
      {"9 N of 10, 1.9 N m of 2", vec3(9, 0, 0), vec3(0, real(1.9), 0)},
      {"8.7 N of 10, askew", vec3(5, 5, 5), vec3(0)},
      {"1.7 N m of 2, askew", vec3(0), vec3(1, 1, 1)},
      {"10 N of 10, at the bound", vec3(6, 8, 0), vec3(0)},
      {"2 N m of 2, at the bound", vec3(0), vec3(0, 0, 2)},
      {"no load", vec3(0), vec3(0)},
      {"10.4 N of 10, 1.7 N m of 2, askew", vec3(6, -6, 6), vec3(-1, 1, 1)},
      {"12 N m of 2, above both bounds", vec3(0), vec3(-4, 8, 8)},
      {"1 N of 10, 2.9 N m of 2", vec3(0, -1, 0), vec3(2, 2, real(0.7))},
      {"2.4 N m of 2 along z", vec3(0), vec3(0, 0, real(2.4))},
      {"12 N of 10 along x", vec3(12, 0, 0), vec3(0)},
      {"3 N m of 2 along x", vec3(0), vec3(3, 0, 0)},
      {"30 N of 10, 1 N m of 2", vec3(0, 30, 0), vec3(0, 0, 1)},
      {"1e6 N and 1e6 N m, unbounded", vec3(1e6, 0, 0), vec3(0, 1e6, 0), {}},
      {"3 N m of 2, force unbounded", vec3(1e6, 0, 0), vec3(0, 3, 0), {unbounded, 2}},
      {"12 N of 10, torque unbounded", vec3(0, 0, 12), vec3(0, 1e6, 0), {10, unbounded}}};
  Random random(54);
  for (int draw = 0; draw < 30; ++draw) {
    BreakCase c{"", random.vector(8), random.vector(real(1.7))};
    c.words = short_number(std::round(10 * double(length(c.force))) / 10) + " N of 10, " +
              short_number(std::round(10 * double(length(c.torque))) / 10) + " N m of 2";
    table.cases.push_back(c);
  }
  table.whole = true;
  return table;
}

}  // namespace joints::testing
