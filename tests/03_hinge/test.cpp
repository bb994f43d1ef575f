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
#include "tests/checker/named.h"

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

TEST_CASE("3.1 the error of an axis is as long as the sine of the angle between the axes",
          "[3.1]") {
  const CaseTable<AxisCase> table = axis_table();
  for (const AxisCase& c : table.cases) {
    const Vector<2> C = c.part.error(c.pair.body1, c.pair.body2);
    const vec3 a1 = c.pair.body1.q * c.part.a1_local;
    const vec3 a2 = c.pair.body2.q * cross(c.part.b_local, c.part.c_local);
    const double length_of_C = std::hypot(C[0], C[1]);
    expect(table.subject, "length of C, " + c.words, length_of_C, double(length(cross(a1, a2))),
           10 * rounding, table.explain(length_of_C));
  }
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
  if (!is_float) check_drawn({"3.1", "C of an axis"}, drawn_axis);  // rounding would hide it
}

// ---- 3.2 ----------------------------------------------------------------------------------------

TEST_CASE("3.2 an impulse along one row changes the rate of another", "[3.2]") {
  const Row a{vec3(0), vec3(0), vec3(1, 0, 0), vec3(0, 2, 0)};
  const Row b{vec3(0), vec3(0), vec3(1, 0, 0), vec3(0, 1, 3)};
  const CaseTable<RowsCase> table = coupling_table();
  table.check({"", a, b, paper}, {5.5});
  table.check();
}

TEST_CASE("3.2 two rows change each other's rates equally", "[3.2]") {
  const CaseTable<RowsCase> table = coupling_table();
  for (const RowsCase& c : table.cases) {
    const double ab = coupling(c.a, c.b, c.pair.body1, c.pair.body2);
    const double ba = coupling(c.b, c.a, c.pair.body1, c.pair.body2);
    expect(table.subject, "b M^-1 a^T beside a M^-1 b^T", ba, ab, 10 * rounding,
           table.explain(ba));
  }
}

TEST_CASE("3.2 nothing moves two static bodies", "[3.2]") {
  const Body wall = static_body(vec3(0)), floor = static_body(vec3(1, 2, 3), paper.body2.q);
  const CaseTable<RowsCase> table = coupling_table();
  for (const RowsCase& c : table.cases) {
    const double yours = coupling(c.a, c.b, wall, floor);
    expect(table.subject, "between two static bodies", yours, 0, 0, table.explain(yours));
  }
}

TEST_CASE("3.2 row by row coupling gives the known K of a rod a ball and an angle", "[3.2]") {
  const CaseTable<RowsCase> table = coupling_table();
  Pair pair = uneven_pair();
  Random random(35);
  move_together(pair, random);
  const Body &one = pair.body1, &two = pair.body2;
  const auto compare = [&](const char* name, const auto& J, const auto& known) {
    const auto yours = K_of(J, one, two);
    for (std::size_t i = 0; i < J.row.size(); ++i)
      for (std::size_t j = 0; j < J.row.size(); ++j)
        expect(table.subject, name, double(yours.m[i][j]), double(known.m[i][j]), 10 * rounding,
               table.explain(double(yours.m[i][j])));
  };
  const real masses = one.inverse_mass + two.inverse_mass;
  const vec3 n = normalize(two.x - one.x);
  compare("K of a rod", to_jacobian(Row{-n, vec3(0), n, vec3(0)}), to_matrix(masses));
  const mat3 s1 = skew(random.vector(1)), s2 = skew(random.vector(1));
  compare("K of a ball joint", jacobian_from_blocks(mat3(-1), s1, mat3(1), -s2),
          to_matrix(mat3(masses) + s1 * inverse_inertia(one) * transpose(s1) +
                    s2 * inverse_inertia(two) * transpose(s2)));
  const HingeAngle angle = HingeAngleFixture::make(pair);
  compare("K of an angle", to_jacobian(angle.jacobian(one, two)), to_matrix(angle.K(one, two)));
  const vec3 p = random.vector(1), q = random.vector(1);  // the crosses of an axis, Eq. 3-6
  const mat3 I = inverse_inertia(one) + inverse_inertia(two);
  compare("K of an axis", turning_rows("", p, q).second,
          Matrix<2>{{{{dot(p, I * p), dot(p, I * q)}, {dot(q, I * p), dot(q, I * q)}}}});
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

TEST_CASE("3.3 a rotation of both bodies together does not change the angle of a hinge", "[3.3]") {
  Random random(36);
  const CaseTable<AngleCase> table = angle_table();
  for (const AngleCase& c : angle_cases(true)) {
    Pair pair = uneven_pair();
    pair.body1.q = c.q1;
    pair.body2.q = c.q2;
    const HingeAngle part{c.a1_local, c.start, 0};
    const double before = part.twist(pair.body1, pair.body2);
    move_together(pair, random);
    const double after = part.twist(pair.body1, pair.body2);
    expect(table.subject, "twist after the turn [rad]", after, before, difference_tolerance,
           table.explain(after));
  }
}

TEST_CASE("3.3 after nearly half a turn a hinge has the right angle and sign", "[3.3]") {
  const CaseTable<AngleCase> table = angle_table();
  for (const double degrees : {179.0, -179.0, 1.0, -1.0, 0.0})
    for (const quat& q1 : {straight, third, -third})
      table.check({short_number(degrees), q1,
                   q1 * rotation(real(degrees * pi / 180) * up_axis) * third, third, up_axis},
                  {degrees});
}

TEST_CASE("3.3 of all angles equal modulo a turn the one nearest to the expected one counts",
          "[3.3]") {
  const CaseTable<TurnsCase> table = turns_table();
  table.check({"-3 near 3.2", -3, 3.2}, {2 * pi - 3});
  table.check({"0.1 near 12.5", 0.1, 12.5}, {0.1 + 4 * pi});
  table.check();
}

TEST_CASE("3.3 a wheel at 1000 rad/s is counted right at 60 steps per second", "[3.3]") {
  const CaseTable<TurnsCase> table = turns_table();
  const real h = real(1) / 60;
  for (const double rate : {1000.0, -1000.0, 3.0}) {
    real counted = 0;
    for (int n = 1; n <= 60; ++n)
      counted = unwrapped(real(std::remainder(n * rate / 60, 2 * pi)), counted + h * real(rate));
    expect(table.subject, "angle after a second at " + short_number(rate), double(counted), rate,
           is_float ? 1e-2 : 1e-8, table.explain(double(counted)));
  }
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

TEST_CASE("3.4 equal limits hold a coordinate at rest", "[3.4]") {
  const CaseTable<LimitCase> table = limit_table();
  const double live = limit_row({1, 1}, 1, 0, real(limit_h)).live;
  expect(table.subject, "live, [1, 1] x 1 rate 0", live, 1, 0,
         table.explain(live, {{0, "two equal limits hold x where it is: always live"}}));
}

TEST_CASE("3.4 without limits there is no row", "[3.4]") {
  const CaseTable<LimitCase> table = limit_table();
  for (const real rate : {real(0), real(50), real(-50)}) {
    const double live = limit_row({}, 3, rate, real(limit_h)).live;
    expect(table.subject, "live, no limits", live, 0, 0,
           table.explain(live, {{1, "without limits C is infinite, and no row is live"}}));
  }
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

TEST_CASE("3.5 a motor gives the same impulse in a step with any number of iterations", "[3.5]") {
  // a rotor of 2 kg m^2 that only the motor turns; a step is 1/60 s
  const CaseTable<MotorCase> table = motor_table();
  const real h = real(1) / 60, inertia = 2;
  for (const real speed : {real(3), real(-3), real(0.01)})
    for (const real strength : {real(10), real(0), real(1e4)})
      for (const int iterations : {1, 10, 100}) {
        real w = 0, sum = 0;
        for (int n = 0; n < iterations; ++n)
          w += motor_impulse(w, 1 / inertia, {speed, strength}, h, sum) / inertia;
        const real most = h * strength / inertia;
        expect(table.subject, "w [rad/s], iterations: " + std::to_string(iterations), double(w),
               double(std::clamp(speed, -most, most)), 100 * rounding,
               table.explain(double(w)));
      }
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

// ---- what the tests know of mistakes ------------------------------------------------------------

TEST_CASE("each usual mistake in the rows of a hinge is called by its name") {
  each_row_is_named<AxisFixture>();
  each_row_is_named<HingeAngleFixture>();
}

TEST_CASE("each usual mistake of chapter 3 is called by its name") {
  are_sound(axis_table(), coupling_table(), angle_table(), turns_table(), limit_table(),
            motor_table());
}
