// The units of chapter 1's exercises.
#include "chapters/01_distance/distance.h"
#include "tests/checker/units.h"

using namespace joints;
using namespace joints::testing;

TEST_CASE("1.1 a row from centre to centre is made of pure numbers", "[1.1]") {
  row_has_units("J", pure, m, [] { return CentreDistance{2 * m}.jacobian(body1, body2); });
}

TEST_CASE("1.2 K of a rod is one over a mass", "[1.2]") {
  has_unit("K", 1 / kg, [] { return CentreDistance{2 * m}.K(body1, body2); });
}

TEST_CASE("1.3 a velocity over an inverse mass is an impulse", "[1.3]") {
  has_unit("lambda", kg * m / s,
           [] { return row_impulse(row, real(0.8) / kg, real(0.3) * m / s, body1, body2); });
}

TEST_CASE("1.3 an impulse over a mass is a velocity", "[1.3]") {
  keeps_velocities("V + M^-1 J^T lambda", [](Body& a, Body& b) {
    apply_impulse(row, real(0.7) * kg * m / s, a, b);
  });
}

TEST_CASE("1.4 a step adds velocities to velocities and displacements to positions", "[1.4]") {
  std::vector<Body> bodies{body1, body2};
  const StepSettings settings{.gravity = vec3(0, -10, 1) * (m / (s * s)), .h = h, .iterations = 2};
  const std::vector<Link> links{{0, 1, 2 * m, true}, {0, 1, 2 * m, false}};
  in("the step", [&] { step(bodies, links, settings); });
  expect_unit("the velocity v", bodies[1].v, m / s);
  expect_unit("the position x", bodies[1].x, m);
}

TEST_CASE("1.5 a sum of impulses is an impulse", "[1.5]") {
  real sum = real(0.4) * kg * m / s;
  has_unit("the change of the sum", kg * m / s, [&] { return clamp_sum(-kg * m / s, sum); });
  expect_unit("the sum", sum, kg * m / s);
}

TEST_CASE("1.6 a row between anchors has arms for the turns", "[1.6]") {
  row_has_units("J", pure, m, [] { return Distance{lever1, lever2, m}.jacobian(body1, body2); });
}

TEST_CASE("1.6 K of a rod between anchors is one over a mass", "[1.6]") {
  has_unit("K", 1 / kg, [] { return Distance{lever1, lever2, m}.K(body1, body2); });
}
