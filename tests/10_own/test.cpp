// The tests of chapter 10's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include <numbers>

#include "checker/check_part.h"
#include "tests/10_own/cone_cases.h"
#include "tests/10_own/part_cases.h"
#include "tests/10_own/screw_cases.h"
#include "tests/checker/catch.h"

using namespace joints;
using namespace joints::testing;

namespace {

const real quarter = std::numbers::pi_v<real> / 2;
Body turned_body(const vec3& turn, const vec3& x = vec3(0)) {
  return body_with(2, vec3(real(0.5), real(0.4), real(0.4)), x, rotation(turn));
}

// Rows at a pose against those worked out by hand.
template <class Fixture, class Part>
void check_by_hand(const Part& part, const Pair& pair, const Row& row) {
  check_jacobian<Fixture>(typename Fixture::Part{part}, pair, Jacobian<1>{{row}});
}

// Errors that are small, and none may be left out for it.
constexpr double nearly_closed[] = {1e-3, -1e-5, 1e-8, -5e-10};
// And large ones, of which nothing may be cut off.
constexpr double far_off[] = {3e3, -3e5, 3e7};
constexpr double of_any_size[] = {1e-3, -1e-5, 1e-8, -5e-10, 3e3, -3e5, 3e7};

}  // namespace

// ---- 10.1 ---------------------------------------------------------------------------------------

TEST_CASE("10.1 axes that lean towards each other by 37 degrees have an error of 0.6", "[10.1]") {
  const vec3 tilt(0, 0, real(0.6435011087932844));  // cosine 0.8, sine 0.6
  const Pair paper{static_body(vec3(0)), turned_body(-tilt)};
  const RightAngle part{vec3(1, 0, 0), vec3(0, 1, 0)};
  right_angle_table().check({"by hand", part, paper}, {0.6});
  for (const double off : nearly_closed)
    right_angle_table().check(
        {"nearly closed", part, {paper.body1, turned_body({0, 0, real(-off)})}}, {std::sin(off)});
  right_angle_table().check();
  check_by_hand<RightAngleFixture>(
      part, paper, Row{vec3(0), vec3(0, 0, real(0.8)), vec3(0), vec3(0, 0, real(-0.8))});
}

TEST_CASE("10.1 the row of a right angle is the slope of its error at every pose", "[10.1]") {
  check_jacobian<RightAngleFixture>();
  for (const double off : nearly_closed) {  // along each other, where the row is nearly zero
    const Row J = RightAngle{vec3(1, 0, 0), vec3(1, 0, 0)}.jacobian(
        static_body(vec3(0)), turned_body({0, 0, real(off)}));
    const vec3 n(0, 0, real(off));
    expect(RightAngleFixture::J, "w1, nearly parallel", J.w1, n, 1e-3 * std::abs(off));
    expect(RightAngleFixture::J, "w2, nearly parallel", J.w2, -n, 1e-3 * std::abs(off));
  }
}

// ---- 10.2 ---------------------------------------------------------------------------------------

TEST_CASE("10.2 a gear of 1 to -2 holds after a quarter turn and half a turn back", "[10.2]") {
  const Gear gear{{vec3(0, 0, 1)}, {vec3(0, 0, 1)}, -2};
  const Pair closed{turned_body(vec3(0, 0, real(0.6))), turned_body(vec3(0, 0, real(-1.2)))};
  const Pair slipped{closed.body1, turned_body(vec3(0, 0, real(-1)))};
  gear_table().check({"by hand", gear, closed}, {0});
  gear_table().check({"by hand, slipped", gear, slipped}, {0.2});
  const Body rest = static_body(vec3(0));
  for (const double off : nearly_closed) {
    const Body turned = turned_body({0, 0, real(off)});
    gear_table().check({"nearly closed", gear, {rest, turned}}, {off});
    gear_table().check({"nearly closed, of wheel 1", gear, {turned, rest}}, {2 * off});
  }
  const real turn = 2 * std::numbers::pi_v<real>;
  for (const double turns : far_off) {
    if (is_float && turns > 100) break;  // float has no digits for a fraction of so many turns
    Gear far = gear;
    far.angle2.expected = turn * real(turns);
    gear_table().check({"far off", far, {rest, rest}}, {double(far.angle2.expected)});
    std::swap(far.angle1, far.angle2);
    gear_table().check({"far off, of wheel 1", far, {rest, rest}},
                       {2 * double(far.angle1.expected)});
  }
  for (const double ratio : of_any_size) {
    if (is_float) break;
    const Gear any{{gear.angle1.a1_local, {1, 0, 0, 0}, turn}, gear.angle2, real(ratio)};
    gear_table().check({"of any ratio", any, {rest, rest}}, {-ratio * double(turn)});
  }
  gear_table().check();
  check_by_hand<GearFixture>(gear, closed, Row{vec3(0), vec3(0, 0, 2), vec3(0), vec3(0, 0, 1)});
}

TEST_CASE("10.2 the row of a gear is the slope of its error, also on tilted axles", "[10.2]") {
  check_jacobian<GearFixture>();
  const Body rest = static_body(vec3(0));
  for (const double ratio : of_any_size) {
    const vec3 w1 = Gear{{vec3(0, 0, 1)}, {vec3(0, 0, 1)}, real(ratio)}.jacobian(rest, rest).w1;
    expect(GearFixture::J, "w1 of ratio " + short_number(ratio), w1, vec3(0, 0, real(-ratio)),
           1e-3 * std::abs(ratio));
  }
}

TEST_CASE("10.2 a gear expects its wheels where they will be after the step", "[10.2]") {
  count_table().check();
}

TEST_CASE("10.2 no angle and no rate is too small or too large to be counted", "[10.2]") {
  const real h = real(0.05);
  const vec3 y(0, 1, 0), z(0, 0, 1);
  const std::vector<std::string> likely = count_table().likely();
  for (const double x : of_any_size)
    for (const bool rotates : {false, true}) {
      const real turned = rotates ? 0 : real(x), rate = rotates ? real(x) : 0;
      Gear gear{{z, {1, 0, 0, 0}, turned}, {y, {1, 0, 0, 0}, turned}, 1};
      Body one = turned_body(turned * z), two = turned_body(turned * y);
      one.w = rate * z, two.w = rate * y;
      gear.count(one, two, h);
      const double right = rotates ? double(h) * x : x;
      const std::string where = " at " + short_number(x) + (rotates ? " rad/s" : " rad");
      for (const auto& [name, angle] : {std::pair("angle1", gear.angle1), {"angle2", gear.angle2}})
        expect_or_say(count_table().subject, std::string(name) + ".expected" + where,
                      double(angle.expected), right, 1e-3 * std::abs(right), likely);
    }
}

TEST_CASE("10.2 wheels that turn by more than half a turn in a step keep their turns", "[10.2]") {
  const real h = real(1) / 60;
  for (const real rate : {real(3), real(-200), real(1000)}) {
    Gear gear{{vec3(0, 0, 1)}, {vec3(0, 1, 0)}, real(-0.5)};
    Body one = turned_body(vec3(0)), two = turned_body(vec3(0));
    one.w = vec3(0, 0, rate), two.w = vec3(0, real(-0.5) * rate, 0);
    const int steps = 60;
    for (int n = 1; n <= steps; ++n) {
      gear.count(one, two, h);
      one.q = rotation(real(n) * h * one.w);
      two.q = rotation(real(n) * h * two.w);
    }
    expect_or_say(count_table().subject, "angle of wheel 1 after a second at " +
                                             short_number(double(rate)) + " rad/s",
                  double(angle_of(gear.angle1, one)), double(steps * h * rate),
                  is_float ? 0.05 : 1e-9, count_table().likely());
  }
}

// ---- 10.3 ---------------------------------------------------------------------------------------

TEST_CASE("10.3 a screw with a lead of 0.2 m moves its nut by 0.05 m in a quarter turn", "[10.3]") {
  const Screw screw{{vec3(0), vec3(0), vec3(0, 0, 1)}, {vec3(0, 0, 1)}, real(0.2)};
  const Pair closed{static_body(vec3(0)), turned_body(quarter * vec3(0, 0, 1),
                                                      vec3(0, 0, real(0.05)))};
  Pair late = closed;
  late.body2.x = vec3(0);
  screw_table().check({"by hand", screw, closed}, {0});
  screw_table().check({"by hand, not moved", screw, late}, {-0.05});
  for (const double off : nearly_closed)
    screw_table().check(
        {"nearly closed", screw, {closed.body1, turned_body(vec3(0), vec3(0, 0, real(off)))}},
        {off});
  for (const double off : far_off)
    screw_table().check(
        {"far off", screw, {closed.body1, turned_body(vec3(0), vec3(0, 0, real(off)))}}, {off});
  screw_table().check();
  const real p = real(0.2) / (4 * quarter);
  check_by_hand<ScrewFixture>(screw, late, Row{vec3(0, 0, -1), vec3(0, 0, p), vec3(0, 0, 1),
                                               vec3(0, 0, -p)});
}

TEST_CASE("10.3 the row of a screw is the slope of its error at every pose", "[10.3]") {
  check_jacobian<ScrewFixture>();
}

// ---- 10.4 ---------------------------------------------------------------------------------------

TEST_CASE("10.4 an axis that has swung by 0.7 has 0.3 left in a cone of 1", "[10.4]") {
  const Cone cone{vec3(1, 0, 0), vec3(1, 0, 0), 1};
  const Pair paper{static_body(vec3(0)), turned_body(vec3(0, 0, real(0.7)))};
  cone_table().check({"by hand", cone, paper}, {0.3});
  for (const double off : nearly_closed)
    cone_table().check({"nearly at the limit", cone,
                        {static_body(vec3(0)), turned_body(vec3(0, 0, real(1 - off)))}}, {off});
  cone_table().check();
  check_by_hand<ConeFixture>(cone, paper, Row{vec3(0), vec3(0, 0, 1), vec3(0), vec3(0, 0, -1)});
}

TEST_CASE("10.4 the row of a cone is the slope of its error on both sides of the limit",
          "[10.4]") {
  check_jacobian<ConeFixture>();
}

TEST_CASE("10.4 along the axis a cone acts against the motion, and at rest not at all", "[10.4]") {
  upright_table().check();
  const Cone cone{vec3(1, 0, 0), vec3(1, 0, 0), 1};
  Body one = turned_body(vec3(0)), two = turned_body(vec3(0));
  for (const vec3& spin : {vec3(0), vec3(4, 0, 0)}) {
    two.w = spin;
    const Row J = cone.jacobian(one, two);
    const VectorSuspect none[] = {
        {J.w2, "at rest, or in a pure twist, no direction is better than another: a row "
               "of zeros"}};
    expect({"10.4", "the row J of a cone at swing 0", 2}, "w2 without a swing", J.w2, vec3(0),
           1e-9, {none[0]});
  }
}

// ---- 10.5 ---------------------------------------------------------------------------------------

namespace {

const Subject own_subject{"10.5", "a part of your own"};

// The reader's part as the checker wants it.
PartFunctions functions_of_own(const OwnPart& part) {
  testing::check(own_subject, part.rows < 1 || part.rows > 6 || !part.error || !part.jacobian
                                  ? "a part has 1 to 6 rows, and functions for C and J"
                                  : "");
  const std::size_t rows = std::size_t(part.rows);
  PartFunctions out{part.rows, part.one_sided, Form::any, nullptr, nullptr, nullptr, {}};
  out.C = [=](const Pair& at) {
    const auto C = part.error(at.body1, at.body2);
    return Numbers(C.begin(), C.begin() + long(rows));
  };
  out.J = [=](const Pair& at) {
    Numbers J;
    for (const Row& row : part.jacobian(at.body1, at.body2))
      for (const double number : flat(to_jacobian(row))) J.push_back(number);
    J.resize(12 * rows);
    return J;
  };
  return out;
}

Pair some_pair(unsigned draw) {
  Random random(draw);
  return drawn_pair(random);
}

}  // namespace

TEST_CASE("10.5 a part is closed in the poses in which it is made", "[10.5]") {
  for (unsigned draw = 1; draw <= 8; ++draw) {
    const Pair pair = some_pair(draw);
    const PartFunctions part = functions_of_own(own_part(pair.body1, pair.body2));
    for (const double C : part.C(pair))
      expect(own_subject, "C in the poses in which it is made", C, 0, 1000 * rounding,
             {{C, "keep in the part what C is now, and subtract it"}});
  }
}

TEST_CASE("10.5 the checker finds the rows of a part right wherever it is made", "[10.5]") {
  for (unsigned draw = 1; draw <= 4; ++draw) {
    const Pair pair = some_pair(draw);
    const PartReport report = check_functions(
        functions_of_own(own_part(pair.body1, pair.body2)),
        [&](PoseRandom& random) {  // near the pose in which it was made
          Pair at = pair;
          move_together(at, random);
          at.body2.x += random.vector(real(0.2));
          at.body2.q = normalize(random.turn(real(0.4)) * at.body2.q);
          return at;
        },
        {.seed = 10 * draw});
    testing::check(own_subject, report.good() ? "" : report.text());
  }
}
