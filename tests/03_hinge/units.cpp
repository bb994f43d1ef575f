// The units of chapter 3's exercises.
#include <cstring>

#include "chapters/03_hinge/hinge.h"
#include "tests/checker/units.h"

using namespace joints;
using namespace joints::testing;

TEST_CASE("3.1 the error of an axis is a pure number", "[3.1]") {
  has_unit("C", pure, [] { return Axis{}.error(body1, body2); });
}

TEST_CASE("3.1 the rows of an axis turn a body and have no arms", "[3.1]") {
  row_of_turns_has_units("J", pure, [] { return Axis{}.jacobian(body1, body2); });
}

TEST_CASE("3.2 an entry of K between two rows with arms is one over a mass", "[3.2]") {
  has_unit("a M^-1 b^T", 1 / kg, [] { return coupling(row, row, body1, body2); });
}

TEST_CASE("3.3 a twist is an angle and so is one that counts turns", "[3.3]") {
  has_unit("the twist", pure, [] { return HingeAngle{}.twist(body1, body2); });
  has_unit("the angle", pure, [] { return unwrapped(-3 * pure, real(3.2) * pure); });
}

// The 0.1 of the live rule is a rate. Rates are pure numbers here, as it is: x is in seconds then.
TEST_CASE("3.4 the gap at a limit is compared with a rate times h", "[3.4]") {
  const auto row = [](real x) { return limit_row({-1 * s, 2 * s}, x, real(0.5) * pure, h); };
  const std::string entry = "limit_row (rates as pure numbers and x in s)";
  for (const real x : {real(-0.99) * s, real(1.99) * s}) {
    expect_unit("C (rates as pure numbers and x in s)", in(entry, [&] { return row(x); }).C, s);
    expect_unit("sign", row(x).sign, pure);
  }
}

TEST_CASE("3.5 the bound of a motor's sum is an impulse", "[3.5]") {
  const Motor motor{3 * m / s, 10 * newton};
  for (const real before : {real(-5), real(0.5), real(5)}) {
    real sum = before * kg * m / s;
    has_unit("the change of the sum", kg * m / s,
             [&] { return motor_impulse(real(0.5) * m / s, 2 / kg, motor, h, sum); });
    expect_unit("the sum", sum, kg * m / s);
  }
}

TEST_CASE("units are not judged for a value that was never set") {
  Quantity k;
  std::memset(static_cast<void*>(&k), 0xfe, sizeof k);  // as the compiler fills it
  for (const Quantity& made : {k, k * m, k / s, sqrt(2 * k)}) CHECK(unset(made));
  for (const Quantity& meant : {0 * m, 3 * kg / s, sqrt(2 / kg), Quantity(5)})
    CHECK(!unset(meant));
}
