// The units of chapter 7's exercises. Colours (7.3) are counted and have none.
#include "chapters/07_performance/performance.h"
#include "tests/checker/units.h"

using namespace joints;
using namespace joints::testing;

namespace {

// A hinge's numbers as they should be, with units.
HingeNumbers<real> numbers_with_units() {
  HingeNumbers<real> out{};
  out.r1 = triple(lever1);
  out.r2 = triple(lever2);
  out.axis_row[0] = triple(direction1 * pure);
  out.axis_row[1] = triple(direction2 * pure);
  for (const auto& [I, body] : {std::pair(&out.I1, &body1), std::pair(&out.I2, &body2)})
    *I = symmetric(inverse_inertia(*body));
  for (int i = 0; i < 5; ++i) {
    out.bias[i] = (i < 3 ? m : pure) / s;
    for (int j = i; j < 5; ++j)
      out.inverse_K[out.place(i, j)] = real(i == j ? 2 : 0.25) * kg *
                                       (j < 3 ? pure : i < 3 ? m : m * m);
  }
  return out;
}
Velocities<real> record_of(const Body& body) {
  return {triple(body.v), body.inverse_mass, triple(body.w), 0};
}

}  // namespace

TEST_CASE("7.1 levers are lengths and axis rows are pure and biases are rates", "[7.1]") {
  const Hinge hinge{{lever1, lever2}, {}, real(0.2) * pure};
  HingeNumbers<real> out{};
  in("the hoisted numbers", [&] { hoist(hinge, body1, body2, h, out); });
  expect_unit("r1", out.r1, m);
  expect_unit("r2", out.r2, m);
  for (const Triple<real>& row : out.axis_row) expect_unit("an axis row", row, pure);
  expect_unit("I1", out.I1, 1 / (kg * m * m));
  expect_unit("I2", out.I2, 1 / (kg * m * m));
  for (int i = 0; i < 3; ++i) expect_unit("a bias of the point", out.bias[i], m / s);
  for (int i = 3; i < 5; ++i) expect_unit("a bias of the axis", out.bias[i], 1 / s);
}

TEST_CASE("7.2 the parts of K differ by an arm each", "[7.2]") {
  const HingeNumbers<real> hinge = numbers_with_units();
  const Matrix<5> K =
      in("K", [&] { return whole_K(hinge, body1.inverse_mass, body2.inverse_mass); });
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) {
      const int turns = (i >= 3) + (j >= 3);
      const char* const parts[] = {"the point's part of K", "the part of K between point and axis",
                                   "the axis' part of K"};
      const real units[] = {1 / kg, 1 / (kg * m), 1 / (kg * m * m)};
      expect_unit(parts[turns], K[i][j], units[turns]);
    }
}

TEST_CASE("7.4 a solve changes velocities by velocities", "[7.4]") {
  const HingeNumbers<real> hinge = numbers_with_units();
  Velocities<real> a = record_of(body1), b = record_of(body2);
  in("the solve", [&] { solve(hinge, a, b); });
  for (const Velocities<real>* body : {&a, &b}) {
    expect_unit("the velocity v", body->v, m / s);
    expect_unit("the angular velocity w", body->w, 1 / s);
    expect_unit("the inverse mass", body->inverse_mass, 1 / kg);
  }
}
