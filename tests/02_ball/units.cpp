// The units of chapter 2's exercises.
#include "chapters/02_ball/ball.h"
#include "tests/checker/units.h"

using namespace joints;
using namespace joints::testing;

namespace {
const Jacobian<3> J = point_by_rates(lever1, lever2);
}  // namespace

TEST_CASE("2.1 the rows of a ball joint have arms for the turns", "[2.1]") {
  row_has_units("J", pure, m, [] { return Point{lever1, lever2}.jacobian(body1, body2); });
}

TEST_CASE("2.2 K of a ball joint is one over a mass", "[2.2]") {
  has_unit("K", 1 / kg, [] { return Point{lever1, lever2}.K(body1, body2); });
}

TEST_CASE("2.3 the impulse of a block is an impulse in every row", "[2.3]") {
  const mat3 K = mat3(3, 1, 0, 1, 2, 1, 0, 1, 4) * (1 / kg);
  has_unit("lambda", kg * m / s,
           [&] { return block_impulse(J, K, direction1 * (m / s), body1, body2); });
}

TEST_CASE("2.3 the impulse of a block over a mass is a velocity", "[2.3]") {
  keeps_velocities("V + M^-1 J^T lambda", [](Body& a, Body& b) {
    apply_impulse(J, direction1 * (kg * m / s), a, b);
  });
}

TEST_CASE("2.4 a body turns by an angle that is a pure number", "[2.4]") {
  has_unit("q", pure, [] { return turned(body1.q, body1.w, h); });
}

TEST_CASE("2.5 a body tumbles by angles that are pure numbers", "[2.5]") {
  Body body = body2;
  in("the free rotation", [&] { tumble(body, h); });
  expect_unit("the orientation q", body.q, pure);
  expect_unit("the angular velocity w", body.w, 1 / s);
  expect_unit("the place x", body.x, m);
  expect_unit("the velocity v", body.v, m / s);
}
