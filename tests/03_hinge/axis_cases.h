// The error of exercise 3.1 as a table of cases: the axis.
#pragma once

#include "tests/checker/cases.h"
#include "tests/checker/joint_fixtures.h"

namespace joints::testing {

struct AxisCase {
  std::string words;
  Axis part;
  Pair pair;
};

/// Both bodies turned anyhow, the axes up to 50 degrees apart.
inline std::vector<AxisCase> axis_cases() {
  std::vector<AxisCase> out;
  Random random(31);
  for (int draw = 0; draw < 12; ++draw) {
    Pair pair = uneven_pair();
    pair.body1.q = random.turn();
    pair.body2.q = random.turn();
    const Axis part = AxisFixture::make(pair);
    AxisFixture::move_freely(part, pair, random);
    if (draw >= 3) pair.body2.q = normalize(random.turn(real(0.5)) * pair.body2.q);
    out.push_back({draw < 3 ? "aligned" : "askew", part, pair});
  }
  return out;
}

inline CaseTable<AxisCase> axis_table() {
  using Case = AxisCase;
  CaseTable<Case> table{{"3.1", "the error C of a hinge's axis"}, {"C.b", "C.c"}, {}, {}, {},
                        axis_cases()};
  judge(table, +[](const Axis& axis, const Body& body1, const Body& body2) {
    return axis.error(body1, body2);
  }, [](auto error, const Case& at) {
    const Vector<2> C = error(at.part, at.pair.body1, at.pair.body2);
    return Numbers{double(C[0]), double(C[1])};
  });
  table.right = [](const Case& at) {
    const vec3 a1 = at.pair.body1.q * at.part.a1_local;
    const auto beside = [&](const vec3& local) { return double(dot(a1, at.pair.body2.q * local)); };
    return Numbers{beside(at.part.b_local), beside(at.part.c_local)};
  };
  table.tolerance = 10 * rounding;
  return table;
}

}  // namespace joints::testing
