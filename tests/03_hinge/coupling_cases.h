// Exercise 3.2 as a table of cases: the coupling of two rows.
#pragma once

#include "tests/checker/cases.h"
#include "tests/checker/joint_fixtures.h"

namespace joints::testing {

struct RowsCase {
  std::string words;
  Row a, b;
  Pair pair;
};

/// Rows with numbers in every block between two uneven bodies that are turned; one of them little,
/// the last four with a static body.
inline std::vector<RowsCase> rows_cases() {
  std::vector<RowsCase> out;
  Random random(32);
  const auto row = [&] {
    return Row{random.vector(1), random.vector(1), random.vector(1), random.vector(1)};
  };
  for (int draw = 0; draw < 12; ++draw) {
    Pair pair = uneven_pair();
    move_together(pair, random);
    Row a = row(), b = row();
    if (draw == 7) a = {real(1e-3) * a.v1, real(1e-3) * a.w1, real(1e-3) * a.v2, real(1e-3) * a.w2};
    if (draw >= 8) {
      Body& wall = draw % 2 ? pair.body2 : pair.body1;
      wall = static_body(wall.x, wall.q);
    }
    out.push_back({draw < 8 ? "any rows" : draw % 2 ? "2 static" : "1 static", a, b, pair});
  }
  return out;
}

inline CaseTable<RowsCase> coupling_table() {
  CaseTable<RowsCase> table{{"3.2", "the coupling of two rows"}, {"a M^-1 b^T"}, {}, {}, {},
                            rows_cases()};
  judge(table, coupling, [](auto coupling, const RowsCase& c) {
    return Numbers{double(coupling(c.a, c.b, c.pair.body1, c.pair.body2))};
  });
  table.right = [](const RowsCase& c) {
    return Numbers{double(dense_K(Jacobian<2>{{c.a, c.b}}, c.pair.body1, c.pair.body2)[0][1])};
  };
  table.tolerance = 10 * rounding;
  return table;
}

}  // namespace joints::testing
