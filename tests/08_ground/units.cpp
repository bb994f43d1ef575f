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

TEST_CASE("8.3 a gap after a step is compared with a length", "[8.3]") {
  const std::vector<real> C(6, real(0.001) * m), rate(6, -2 * m / s);
  in("the live corners", [&] { return live_corners(C, rate, h, real(0.1) * m / s).size(); });
}

namespace {
std::vector<ContactRows> a_corner() {
  ContactRows out;
  for (const std::size_t i : {0, 1, 2}) out.J[i] = row, out.K[i] = 2 / kg;
  out.bias = real(0.5) * m / s;
  for (real& sum : out.sum) sum = 3 * kg * m / s;
  return {out};
}
}  // namespace

TEST_CASE("8.3 the sums of an iteration are impulses", "[8.3]") {
  Body one = body1, two = body2;
  std::vector<ContactRows> corners = a_corner();
  in("the iteration", [&] { return solve_contact(corners, real(0.5) * pure, one, two), 0; });
  for (const real sum : corners[0].sum) expect_unit("a sum", sum, kg * m / s);
  expect_unit("the velocity", two.v, m / s);
}

TEST_CASE("8.4 the speed of an impact, and the sums of a rebound", "[8.4]") {
  has_unit("v_hit", m / s, [&] {
    return impact_speed(real(0.1) * m, -5 * m / s, real(-0.2) * m / s, h);
  });
  Body one = body1, two = body2;
  std::vector<ContactRows> corners = a_corner();
  const std::vector<Bounce> bounces{{4 * m / s, real(0.5) * pure}};
  in("the rebound", [&] { return rebound(corners, bounces, 2, one, two), 0; });
  expect_unit("the sum", corners[0].sum[2], kg * m / s);
}
