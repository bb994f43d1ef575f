// The tests of chapter 2's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include "tests/checker/catch.h"
#include "tests/02_ball/block_cases.h"
#include "tests/02_ball/drawn_cases.h"
#include "tests/02_ball/rotation_cases.h"
#include "tests/02_ball/tumble_cases.h"
#include "tests/checker/fixtures.h"

using namespace joints;
using namespace joints::testing;

namespace {
const Point paper_part{vec3(0), vec3(1, 0, real(0.5))};  // of the pose in the chapter's text
}  // namespace

TEST_CASE("2.1 the rows of a ball joint hold a unit matrix and the matrix of a lever", "[2.1]") {
  Jacobian<3> J;  // the lever of body 2 is (0, 1, 1/2)
  J[0] = {vec3(-1, 0, 0), vec3(0), vec3(1, 0, 0), vec3(0, real(0.5), -1)};
  J[1] = {vec3(0, -1, 0), vec3(0), vec3(0, 1, 0), vec3(real(-0.5), 0, 0)};
  J[2] = {vec3(0, 0, -1), vec3(0), vec3(0, 0, 1), vec3(1, 0, 0)};
  check_jacobian<PointFixture>(paper_part, {ball_paper1, ball_paper2}, J);
}

TEST_CASE("2.1 the rows of a ball joint are the slopes of its gap at every pose", "[2.1]") {
  check_jacobian<PointFixture>();
}

TEST_CASE("2.1 the rows of a ball joint hold levers of any length", "[2.1]") {
  check_drawn(PointFixture::J, [](Draw& d) { return drawn_point(d, false); });
}

TEST_CASE("2.2 K of a ball joint is the change of the anchor's velocity by an impulse", "[2.2]") {
  // world inverse inertia diag(1, 1.2, 4.2), lever (0, 1, 1/2), mass 2 kg
  const mat3 K(5, 0, 0, 0, real(0.75), real(-0.5), 0, real(-0.5), real(1.5));
  check_K<PointFixture>(paper_part, {ball_paper1, ball_paper2}, to_matrix(K));
}

TEST_CASE("2.2 K of a ball joint is J M^-1 J^T at every pose", "[2.2]") {
  check_K<PointFixture>();
}

TEST_CASE("2.2 K between two static bodies is zero", "[2.2]") {
  const mat3 K = paper_part.K(ball_paper1, static_body(vec3(1, 2, 3)));
  expect(PointFixture::K, "K", K, mat3(0), 0,
         {{K, "#unit-matrix-between-walls between two static bodies K is 0: nothing is added to "
              "it"}});
}

TEST_CASE("2.2 K of a ball joint is right for levers and masses of any size", "[2.2]") {
  check_drawn(PointFixture::K, [](Draw& d) { return drawn_point(d, true); });
}

// ---- 2.3 ----------------------------------------------------------------------------------------

TEST_CASE("2.3 the impulse of a block removes all three rates at once", "[2.3]") {
  const CaseTable<LackCase> table = block_impulse_table();
  table.check(table.cases[0], {0.2, 0, 0});
  table.check();
}

TEST_CASE("2.3 the impulse of a block changes velocities by M^-1 J^T lambda", "[2.3]") {
  const CaseTable<PushCase> table = block_push_table();
  table.check(table.cases[0],
              {0, 0, 0, 0, 0, 0, 1.1, 0, 0, 0, 0.12, 1.16, 0, 0, 0, 0, -1, 0});
  table.check();
}

TEST_CASE("2.3 a block takes its rates away whatever the masses and lengths and sides", "[2.3]") {
  check_drawn({"2.3", "the impulse of a block"}, drawn_block_impulse);
}

TEST_CASE("2.3 each body that can move takes its half of a block's impulse, however small",
          "[2.3]") {
  check_drawn({"2.3", "applying the impulse of a block", 2}, drawn_block_push);
}

// ---- 2.4 ----------------------------------------------------------------------------------------

TEST_CASE("2.4 a third of a turn a second for 0.75 s is a quarter turn", "[2.4]") {
  const CaseTable<RotationCase> table = rotation_table();
  table.check(table.cases[0], {double(half_root), 0, 0, double(half_root)});
}

TEST_CASE("2.4 a constant angular velocity rotates a body by exp(h w) in the world", "[2.4]") {
  rotation_table().check();
}

TEST_CASE("2.4 the new orientation has length 1, even if the old one has not", "[2.4]") {
  const quat q = real(1.001) * rotation(vec3(1, 2, 3));
  expect({"2.4", "turning a body"}, "length of q, which was 1.001",
         double(length(turned(q, vec3(1, -1, 2), real(0.1)))), 1, rounding,
         {{1.001, "#not-normalised the product is not normalised: rounding adds up over many "
                  "steps"}});
}

TEST_CASE("2.4 a body turns right by any angle, small ones and several turns", "[2.4]") {
  if (!is_float) check_drawn({"2.4", "turning a body"}, drawn_rotation, 1e-9, 400);
}

// ---- 2.5 ----------------------------------------------------------------------------------------

TEST_CASE("2.5 about an axis of its own a body rotates as it does at a constant rate", "[2.5]") {
  // body 2 of the text, upright: 2 rad/s about its least moment for a tenth of a second
  const Body body = spinning({real(5) / 6, 1, real(5) / 21}, {0, 0, 2});
  const vec3 none(0);
  check_vectors(tumble_table(), {"on paper", body, 0.1},
                flat({vec3(0, 0, std::sin(real(0.1))), vec3(0, 0, 2), none, none, none,
                      vec3(1, 0, 0)}), 10 * rounding);
}

TEST_CASE("2.5 a body rotates about its own axes and about its angular momentum", "[2.5]") {
  check_vectors(tumble_table());
}

TEST_CASE("2.5 a body of any size tumbles right at any speed, forwards and backwards", "[2.5]") {
  check_drawn(tumbling, drawn_tumble);
}

TEST_CASE("2.5 in twenty seconds the angular momentum stays and the energy only swings",
          "[2.5]") {
  const auto likely = tumble_table().likely();
  Random random(26);
  for (int draw = 0; draw < 3; ++draw) {
    const Body body = spinning({1, real(0.7), real(0.4)}, real(4) * normalize(random.vector(1)),
                               random.turn());
    const auto [energy, momentum] = greatest_changes(body, 1.0 / 60);
    expect_or_say(tumbling, "greatest change of L, as a fraction", momentum, 0,
                  is_float ? 1e-3 : 1e-10, likely);
    expect_or_say(tumbling, "greatest change of the energy, as a fraction", energy, 0, 2e-3,
                  likely);
  }
}

TEST_CASE("2.5 a brick turns over as often as it does in far smaller steps", "[2.5]") {
  const int right = turnings(rotate_freely, 20, 1.0 / 3000);
  expect_or_say(tumbling, "turnings about the middle axis in 20 s", turnings(tumble, 20, 1.0 / 60),
                right, 0.5, tumble_table().likely());
}

TEST_CASE("2.5 half the step has a quarter of the error", "[2.5]") {
  if (is_float) return;  // rounding would hide it
  const auto likely = tumble_table().likely();
  const Body body = spinning({1, real(0.7), real(0.4)}, {2, 3, -1}, rotation(vec3(1, 2, 3)));
  const double coarse = off_after_a_second(body, 20), fine = off_after_a_second(body, 40);
  expect_or_say(tumbling, "error of 20 steps over that of 40", coarse / fine, 4, 0.3, likely);
}

TEST_CASE("2.5 a wheel tumbles exactly at any speed", "[2.5]") {
  const Body body = spinning({1, real(0.6), real(0.6)}, {40, 30, -20}, rotation(vec3(1, 2, 3)));
  Body once = body, often = body;
  tumble(once, real(0.5));
  for (int n = 0; n < 50; ++n) tumble(often, real(0.01));
  expect(tumbling, "q after a step of 0.5 s, beside fifty steps of 0.01 s", once.q, often.q,
         is_float ? 1e-2 : 1e-10);
}

TEST_CASE("2.5 a step back undoes a step", "[2.5]") {
  const Body body = spinning({1, real(0.7), real(0.4)}, {2, 3, -1}, rotation(vec3(1, 2, 3)));
  Body moved = body;
  tumble(moved, real(0.2));
  tumble(moved, real(-0.2));
  expect(tumbling, "q after a step of 0.2 s and one of -0.2 s", moved.q, body.q, 100 * rounding);
}
