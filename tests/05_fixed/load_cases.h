// Exercise 5.2 as tables of cases: the load of a weld, and the same load
// about another point.
#pragma once

#include "chapters/05_fixed/fixed.h"
#include "tests/checker/pose_cases.h"

namespace joints::testing {

// ---- the load -----------------------------------------------------------------------------------

struct LoadCase {
  std::string words;
  Vector<6> impulse;
  real h;
};

inline CaseTable<LoadCase> load_table() {
  CaseTable<LoadCase> table{{"5.2", "the load of a weld"}, with_xyz({"force", "torque"}),
                            {}, {}, {}, {}};
  judge(table, carried, [](auto carried, const LoadCase& c) {
    const Reaction load = carried(c.impulse, c.h);
    Numbers out;
    append(out, load.force);
    append(out, load.torque);
    return out;
  });
  table.right = [](const LoadCase& c) {
    Numbers out;
    for (const real a : c.impulse) out.push_back(double(a / c.h));
    return out;
  };
  table.cases = {{"h = 0.25", {real(0.3), real(-0.2), real(0.7), real(-0.4), real(0.1), real(0.6)},
                  real(0.25)},
                 {"h = 0.016", {real(-1), real(0.5), real(0.2), real(0.9), real(-0.8), real(0.35)},
                  real(0.016)}};
  table.tolerance = 1000 * rounding;
  return table;
}

// ---- about another point ------------------------------------------------------------------------

struct AboutCase {
  std::string words;
  Reaction load;
  vec3 from, to;
};

inline CaseTable<AboutCase> about_table() {
  CaseTable<AboutCase> table{{"5.2", "the load about another point", 2},
                             with_xyz({"torque", "force"}), {}, {}, {}, {}};
  const auto numbers = [](const Reaction& load) {
    Numbers out;
    append(out, load.torque);
    append(out, load.force);
    return out;
  };
  judge(table, about, [=](auto about, const AboutCase& c) {
    return numbers(about(c.load, c.from, c.to));
  });
  table.right = [=](const AboutCase& c) {
    return numbers({c.load.force, c.load.torque + skew(c.load.force) * (c.to - c.from)});
  };
  Random random(52);
  for (int draw = 0; draw < 8; ++draw)
    table.cases.push_back({"points anywhere", {random.vector(5), random.vector(5)},
                           random.vector(2), random.vector(2)});
  table.cases.push_back({"points close together", {random.vector(5), random.vector(5)},
                         vec3(1, 2, 3), vec3(1, real(2.02), real(2.99))});
  table.tolerance = 10 * rounding;
  return table;
}

}  // namespace joints::testing
