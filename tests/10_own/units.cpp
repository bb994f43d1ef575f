// The units of chapter 10's exercises.
#include "chapters/10_own/own.h"
#include "tests/checker/units.h"

using namespace joints;
using namespace joints::testing;

TEST_CASE("10.1 the error of a right angle is a pure number and its row only turns", "[10.1]") {
  has_unit("C", pure, [] { return RightAngle{}.error(body1, body2); });
  row_of_turns_has_units("J", pure, [] { return RightAngle{}.jacobian(body1, body2); });
}

TEST_CASE("10.2 the error of a gear is an angle, and so is what it expects", "[10.2]") {
  Gear gear;
  gear.ratio = real(-2) * pure;
  has_unit("C", pure, [&] { return gear.error(body1, body2); });
  row_of_turns_has_units("J", pure, [&] { return gear.jacobian(body1, body2); });
  Body one = body1, two = body2;
  one.w = two.w = vec3(1, 2, 3) / s;
  in("count", [&] { gear.count(one, two, h); });
  expect_unit("angle1.expected", gear.angle1.expected, pure);
  expect_unit("angle2.expected", gear.angle2.expected, pure);
}

TEST_CASE("10.3 the error of a screw is a length, and its row has levers", "[10.3]") {
  Screw screw;
  screw.slide.anchor1_local = screw.slide.anchor2_local = vec3(1, 2, 3) * m;
  screw.lead = real(0.2) * m;
  has_unit("C", m, [&] { return screw.error(body1, body2); });
  row_has_units("J", pure, m, [&] { return screw.jacobian(body1, body2); });
}

TEST_CASE("10.4 the error of a cone is an angle and its row only turns", "[10.4]") {
  has_unit("C", pure, [] { return Cone{}.error(body1, body2); });
  row_of_turns_has_units("J", pure, [] { return Cone{}.jacobian(body1, body2); });
}
