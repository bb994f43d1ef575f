// The tests of chapter 3's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include <numbers>

#include "tests/03_hinge/angle_cases.h"
#include "tests/03_hinge/axis_cases.h"
#include "tests/03_hinge/coupling_cases.h"
#include "tests/03_hinge/drawn_cases.h"
#include "tests/03_hinge/limit_cases.h"
#include "tests/03_hinge/motor_cases.h"
#include "tests/03_hinge/turns_cases.h"
#include "tests/checker/catch.h"

using namespace joints;
using namespace joints::testing;

// ---- 3.1 ----------------------------------------------------------------------------------------

namespace {

// The pose for pencil and paper in the chapter's text: body 2 tilted about x by cos .8 and sin .6.
const Pair paper{static_body(vec3(0)),
                 body_with(2, vec3(real(0.5), real(0.4), real(0.4)), vec3(1, 0, 0),
                           quat(std::sqrt(real(0.9)), std::sqrt(real(0.1)), 0, 0))};
const Axis paper_axis{vec3(0, 0, 1), vec3(1, 0, 0), vec3(0, 1, 0)};

// The rows of the exercise beside an error that is right whatever the exercise's own is.
struct AxisReference : Axis {
  Vector<2> error(const Body& body1, const Body& body2) const {
    const vec3 a1 = body1.q * a1_local;
    return {dot(a1, body2.q * b_local), dot(a1, body2.q * c_local)};
  }
};
struct AxisTwinFixture : AxisFixture {
  using Part = AxisReference;
  static Part make(const Pair& pair) { return {AxisFixture::make(pair)}; }
};

}  // namespace

TEST_CASE("3.1 an axis that is tilted by 37 degrees has an error of 0.6", "[3.1]") {
  const CaseTable<AxisCase> table = axis_table();
  table.check({"tilted", paper_axis, paper}, {0, 0.6});
  table.check();
}

TEST_CASE("3.1 the rows of an axis hold cross products with it", "[3.1]") {
  check_jacobian<AxisTwinFixture>(
      AxisReference{paper_axis}, paper,
      Jacobian<2>{{Row{vec3(0), vec3(0, 1, 0), vec3(0), vec3(0, -1, 0)},
                   Row{vec3(0), vec3(real(-0.8), 0, 0), vec3(0), vec3(real(0.8), 0, 0)}}});
}

TEST_CASE("3.1 the rows of an axis are the slopes of its error at every pose", "[3.1]") {
  check_jacobian<AxisTwinFixture>();
}

TEST_CASE("3.1 beyond 60 degrees the rows of an axis turn about c and b", "[3.1]") {
  Pair far = paper;
  far.body2.q = rotation(vec3(2, 0, 0));  // there a1 above the exercise's place holds b x c
  const Jacobian<2> J = paper_axis.jacobian(far.body1, far.body2);
  const vec3 a1(0, 0, 1), b = far.body2.q * vec3(1, 0, 0), c = far.body2.q * vec3(0, 1, 0);
  const char* const taken = "#nearer-half-only take a1 as it stands above: beyond 60 degrees it "
                            "holds body 2's axis";
  expect(AxisFixture::J, "w2 of row b", J[0].w2, -c, rounding,
         {{cross(b, a1), taken}, {c, "the sign: b x a1, not a1 x b"}});
  expect(AxisFixture::J, "w2 of row c", J[1].w2, b, rounding, {{cross(c, a1), taken}});
}

TEST_CASE("3.1 the error of an axis is right between axes of any angle", "[3.1]") {
  if (is_float) return;  // rounding would hide it
  check_drawn({"3.1", "C of an axis"}, [](Draw& d) { return drawn_axis(d, false); });
}

TEST_CASE("3.1 the rows of an axis have all digits between axes of any angle", "[3.1]") {
  check_drawn(AxisFixture::J, [](Draw& d) { return drawn_axis(d, true); });
}

// ---- 3.2 ----------------------------------------------------------------------------------------

TEST_CASE("3.2 an impulse along one row changes the rate of another", "[3.2]") {
  const Row a{vec3(0), vec3(0), vec3(1, 0, 0), vec3(0, 2, 0)};
  const Row b{vec3(0), vec3(0), vec3(1, 0, 0), vec3(0, 1, 3)};
  const CaseTable<RowsCase> table = coupling_table();
  table.check({"", a, b, paper}, {5.5});
  table.check();
}

TEST_CASE("3.2 two rows are coupled alike in all units and beside a wall", "[3.2]") {
  check_drawn({"3.2", "the coupling of two rows"}, drawn_coupling);
}

// ---- 3.3 ----------------------------------------------------------------------------------------

namespace {
constexpr double pi = std::numbers::pi;
const real half = std::sqrt(real(0.5));
const quat straight(1, 0, 0, 0), third(real(0.5), real(0.5), real(0.5), real(0.5));
const vec3 up_axis(0, 0, 1);
}  // namespace

TEST_CASE("3.3 a third of a turn about the diagonal twists a hinge by 90 degrees", "[3.3]") {
  const CaseTable<AngleCase> table = angle_table();
  table.check({"on paper", straight, third, straight, up_axis}, {90});
  table.check({"from -q2", straight, -third, straight, up_axis}, {90});
  table.check({"from start", straight, third, quat(half, 0, 0, half), up_axis}, {0});
}

TEST_CASE("3.3 the angle of a hinge is its twist however both bodies are turned and swung",
          "[3.3]") {
  angle_table().check();
}

TEST_CASE("3.3 of all angles equal modulo a turn the one nearest to the expected one counts",
          "[3.3]") {
  const CaseTable<TurnsCase> table = turns_table();
  table.check({"-3 near 3.2", -3, 3.2}, {2 * pi - 3});
  table.check({"0.1 near 12.5", 0.1, 12.5}, {0.1 + 4 * pi});
  table.check();
}

TEST_CASE("3.3 a twist is right near half a turn and near none", "[3.3]") {
  if (!is_float) check_drawn({"3.3", "the twist of a hinge"}, drawn_twist, 1e-9, 400);
}

TEST_CASE("3.3 thousands of turns are counted", "[3.3]") {
  check_drawn({"3.3", "counting turns", 2}, drawn_unwrapped);
}

// ---- 3.4 ----------------------------------------------------------------------------------------

TEST_CASE("3.4 a limit needs a row before it is reached", "[3.4]") {
  const CaseTable<LimitCase> table = limit_table();
  table.check(limit_case(-1, 2, 1.9, 0.5), {0.1, -1, 0});
  table.check(limit_case(-1, 2, 1.9, 3), {0.1, -1, 1});
  table.check(limit_case(-1, 2, -1.05, 0), {-0.05, 1, 1});
}

TEST_CASE("3.4 of two limits the one with the smaller gap AFTER the step counts", "[3.4]") {
  limit_table().check();
}

TEST_CASE("3.4 limits of any range have their row in time", "[3.4]") {
  check_drawn({"3.4", "the row of a limit"}, drawn_limit);
}

// ---- 3.5 ----------------------------------------------------------------------------------------

TEST_CASE("3.5 a motor gives no more than its strength in a step", "[3.5]") {
  const CaseTable<MotorCase> table = motor_table();
  table.check({"iteration 1", 0, 0.5, 3, 10, 0}, {1, 1});
  table.check({"iteration 2", 0.5, 0.5, 3, 10, 1}, {0, 1});
  table.check();
}

TEST_CASE("3.5 a motor takes back the excess of its impulse", "[3.5]") {
  // between two iterations something else speeds the rotor up: the sum sinks to its lower bound
  const CaseTable<MotorCase> table = motor_table();
  real w = 0, sum = 0;
  w += motor_impulse(w, real(0.5), {3, 10}, real(0.1), sum) / 2;
  w = 4;
  w += motor_impulse(w, real(0.5), {3, 10}, real(0.1), sum) / 2;
  expect(table.subject, "sum after a push from outside", double(sum), -1, 10 * rounding,
         table.explain(double(sum)));
  expect(table.subject, "w after a push from outside", double(w), 3, 10 * rounding,
         table.explain(double(w)));
}

TEST_CASE("3.5 a motor of any strength is bounded, whatever it gave before", "[3.5]") {
  check_drawn({"3.5", "the impulse of a motor"}, drawn_motor);
}
