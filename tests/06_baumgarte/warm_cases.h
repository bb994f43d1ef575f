// Exercise 6.2, the warm start, as a table of cases.
#pragma once

#include "chapters/06_baumgarte/baumgarte.h"
#include "tests/checker/fixtures.h"
#include "tests/checker/vector_cases.h"

namespace joints::testing {

// ---- what an impulse does -----------------------------------------------------------------------

/// M^-1 J^T lambda: what an impulse does to velocities, or Eq. 6-11 to poses.
struct Moves {
  vec3 way1{0}, turn1{0}, way2{0}, turn2{0};
};
template <int N>
Moves response(const Jacobian<N>& J, const Vector<N>& lambda, const Pair& pair) {
  std::array<Row, N> responses;
  form_responses(J.row.data(), N, pair.body1, pair.body2, responses.data());
  Moves out;
  for (std::size_t i = 0; i < N; ++i) {
    const auto& [v1, w1, v2, w2] = responses[i];
    out.way1 += lambda[i] * v1, out.turn1 += lambda[i] * w1;
    out.way2 += lambda[i] * v2, out.turn2 += lambda[i] * w2;
  }
  return out;
}

// ---- 6.2 the warm start -------------------------------------------------------------------------

struct WarmCase {
  std::string words;
  Jacobian<3> J;
  double ratio;
  vec3 lambda;
  Pair pair;
};

/// The rows of a ball joint between two turned bodies that fly and spin.
inline WarmCase warm_case(const std::string& words, double ratio, unsigned seed) {
  Random random(seed);
  Pair pair = uneven_pair();
  move_together(pair, random);
  for (Body* body : {&pair.body1, &pair.body2}) {
    body->v = random.vector(2);
    body->w = random.vector(2);
  }
  const Point part = point_at(pair.body1, pair.body2, pair.body1.x + random.vector(1));
  return {words, numeric_jacobian(part, pair.body1, pair.body2), ratio, random.vector(2), pair};
}

inline CaseTable<WarmCase> warm_table() {
  using Case = WarmCase;
  CaseTable<Case> table{{"6.2", "the warm start"},
                        {"lambda kept", "change of v1", "change of w1", "change of v2",
                         "change of w2"}, {}, {}, {}, {}};
  judge(table, warm_start, [](auto start, const Case& c) {
    vec3 lambda = c.lambda;
    Pair after = c.pair;
    start(c.J, real(c.ratio), lambda, after.body1, after.body2);
    return flat({lambda, after.body1.v - c.pair.body1.v, after.body1.w - c.pair.body1.w,
                 after.body2.v - c.pair.body2.v, after.body2.w - c.pair.body2.w});
  });
  table.right = [](const Case& c) {
    const vec3 lambda = real(c.ratio) * c.lambda;
    const Moves a = response<3>(c.J, to_vector(lambda), c.pair);
    return flat({lambda, a.way1, a.turn1, a.way2, a.turn2});
  };
  table.cases = {warm_case("shorter step", 0.5, 621), warm_case("equal steps", 1, 622),
                 warm_case("longer step", 1.5, 623), warm_case("1 static", 0.8, 624)};
  Body& wall = table.cases.back().pair.body1;
  wall = static_body(wall.x, wall.q);
  table.tolerance = 10 * rounding;
  return table;
}

}  // namespace joints::testing
