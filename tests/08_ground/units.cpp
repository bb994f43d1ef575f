// The units of chapter 8's exercises.
#include "chapters/08_ground/ground.h"
#include "tests/checker/units.h"

using namespace joints;
using namespace joints::testing;

namespace {
const Corner corner{lever2, real(0.3) * m, real(0.5) * m};
}

TEST_CASE("8.1 the gap of a corner is a length", "[8.1]") {
  has_unit("C", m, [] { return corner.error(body1, body2); });
}

TEST_CASE("8.1 the row of a corner has an arm at each turn", "[8.1]") {
  row_has_units("J along n", pure, m, [] { return corner.jacobian(body1, body2); });
  row_has_units("J along t1", pure, m, [] { return corner.along(direction1, body1, body2); });
}

TEST_CASE("8.2 the directions of friction are pure numbers", "[8.2]") {
  const vec3 n = cross(direction1, direction2) * pure;
  for (const vec3& sliding : {vec3(3, -2, real(0.5)) * (m / s), n * (-3 * m / s),
                              vec3(0) * (m / s)}) {
    const std::array<vec3, 2> t = in("t1, t2", [&] { return tangents(n, sliding); });
    expect_unit("t1", t[0], pure);
    expect_unit("t2", t[1], pure);
  }
}

TEST_CASE("8.2 the sum of friction and its bound are impulses", "[8.2]") {
  for (const real before : {real(-5), real(0.5), real(5)}) {
    real sum = before * kg * m / s;
    has_unit("the change of the sum", kg * m / s, [&] {
      return friction_impulse(real(0.5) * m / s, 2 / kg, real(0.5) * pure, 3 * kg * m / s, sum);
    });
    expect_unit("the sum", sum, kg * m / s);
  }
}
