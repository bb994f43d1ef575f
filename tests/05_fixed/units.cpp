// The units of chapter 5's exercises.
#include "chapters/05_fixed/fixed.h"
#include "tests/checker/units.h"

using namespace joints;
using namespace joints::testing;

TEST_CASE("5.1 the cross block of a weld has one arm only", "[5.1]") {
  has_unit("X", 1 / (kg * m), [] { return cross_K({lever1, lever2}, body1, body2); });
}

TEST_CASE("5.2 an impulse over h is a force", "[5.2]") {
  const real push = kg * m / s, turn = push * m;
  const Vector<6> impulse{push, 2 * push, -push, turn, -2 * turn, turn};
  const Reaction load = in("the load", [&] { return carried(impulse, h); });
  expect_unit("the force", load.force, newton);
  expect_unit("the torque", load.torque, newton * m);
}

TEST_CASE("5.2 a torque about another point grows by a force with an arm", "[5.2]") {
  const Reaction load{direction1 * newton, direction2 * (newton * m)};
  const Reaction moved = in("the load", [&] { return about(load, lever1, lever2); });
  expect_unit("the force", moved.force, newton);
  expect_unit("the torque", moved.torque, newton * m);
  in("breaks", [&] { return breaks(load, {3 * newton, 2 * newton * m}); });
}

TEST_CASE("5.3 the rows of a sleeve and their load", "[5.3]") {
  const vec3 third = cross(direction1, direction2) * pure;
  const Kit kit{{lever1, lever2}, {lever1, lever2, direction1, third}, {direction2, third,
                direction1}, {}};
  const FourRows rows = in("the block", [&] { return sleeve(kit, body1, body2); });
  expect_unit("C[0]", rows.C[0], m);
  expect_unit("C[2]", rows.C[2], pure);
  expect_unit("K[0, 0]", rows.K[0][0], 1 / kg);
  expect_unit("K[0, 2]", rows.K[0][2], 1 / (kg * m));
  expect_unit("K[3, 3]", rows.K[3][3], 1 / (kg * m * m));
  const real push = kg * m / s;
  const Reaction load = in("the load", [&] {
    return transmitted(rows.J, {push, 2 * push, push * m, 2 * push * m}, h, body2, lever1);
  });
  expect_unit("the force", load.force, newton);
  expect_unit("the torque", load.torque, newton * m);
}
