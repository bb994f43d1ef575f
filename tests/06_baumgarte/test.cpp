// The tests of chapter 6's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include "tests/06_baumgarte/baumgarte_cases.h"
#include "tests/06_baumgarte/drawn_cases.h"
#include "tests/06_baumgarte/safety_cases.h"
#include "tests/06_baumgarte/soft_steps.h"
#include "tests/06_baumgarte/torn_joints.h"
#include "tests/checker/catch.h"

using namespace joints;
using namespace joints::testing;

// ---- 6.1 ----------------------------------------------------------------------------------------

TEST_CASE("6.1 a gap of two centimetres is closed at eighteen centimetres a second", "[6.1]") {
  bias_table().check(bias_case(0.02, 0.15, 60), {0.18});
}

TEST_CASE("6.1 the bias is a fraction of the error over the step", "[6.1]") {
  bias_table().check();
}

TEST_CASE("6.1 a limit that is passed comes back softly and one ahead is just reached", "[6.1]") {
  const CaseTable<BiasCase> table = limit_bias_table();
  table.check(bias_case(-0.02, 0.15, 60), {-0.18});
  table.check(bias_case(0.02, 0.15, 60), {1.2});
  table.check(bias_case(0, 0.15, 60), {0});
  table.check();
}

TEST_CASE("6.1 a half-time of six steps removes eleven percent per step", "[6.1]") {
  half_time_table().check(half_time_case(0.1, 60), {0.109101281859661});  // 1 - 2^(-1/6)
}

TEST_CASE("6.1 beta for a half-time follows the step", "[6.1]") { half_time_table().check(); }

TEST_CASE("6.1 biases are right in all units and on both sides of zero", "[6.1]") {
  check_drawn({"6.1", "the bias"}, [](Draw& d) { return drawn_bias(d, false); });
  check_drawn({"6.1", "the bias of a limit", 2}, [](Draw& d) { return drawn_bias(d, true); });
  check_drawn({"6.1", "beta for a half-time", 3}, drawn_beta);
}

// ---- 6.2 ----------------------------------------------------------------------------------------

TEST_CASE("6.2 half a step begins with half the impulse", "[6.2]") {
  // a weight of 3 kg that hangs at its centre: 3 N s in the last step, a step half as long now
  const Jacobian<3> J = jacobian_from_blocks(mat3(-1), mat3(0), mat3(1), mat3(0));
  const Pair pair{static_body(vec3(0)), body_with(3, vec3(1), vec3(0))};
  const vec3 none(0);
  check_vectors(warm_table(), {"on paper", J, 0.5, vec3(0, 3, 0), pair},
                flat({vec3(0, real(1.5), 0), none, none, vec3(0, real(0.5), 0), none}), rounding);
}

TEST_CASE("6.2 the stored impulse is the one that acted on both bodies at every pose", "[6.2]") {
  check_vectors(warm_table());
}

TEST_CASE("6.2 a chain of ten links needs six iterations for a warm start beside beta", "[6.2]") {
  const CaseTable<SafetyCase> table = safety_table();
  for (const int iterations : {4, 5}) table.check(safety_case(ten_links, iterations, 0.15), {0});
  for (const int iterations : {6, 10}) table.check(safety_case(ten_links, iterations, 0.15), {1});
  table.check();
}

TEST_CASE("6.2 a row that is not safe diverges and a safe one settles", "[6.2]") {
  const CaseTable<SafetyCase> table = safety_table();
  for (const SafetyCase& c : table.cases) {
    if (c.rho == 0.5 || c.beta == 0) continue;  // at the bound; nothing brings C back
    table.check(c, {runs_away(c) < 1e-3 ? 1.0 : 0.0});
  }
}

TEST_CASE("6.2 a warm start gives impulses of any size to both bodies", "[6.2]") {
  check_drawn({"6.2", "the warm start"}, drawn_warm_start);
}

TEST_CASE("6.2 what is just safe is safe with any number of iterations", "[6.2]") {
  if (!is_float) check_drawn({"6.2", "the bound of a warm start", 2}, drawn_safety);
}

// ---- 6.3 ----------------------------------------------------------------------------------------

namespace {

// The pose for pencil and paper in the text: a gap of (0, 0.1, 0).
const Pair paper{static_body(vec3(0)),
                 body_with(2, vec3(real(0.5), real(0.5), real(0.5)), vec3(1, 0, 0))};
const Point paper_point{vec3(0), vec3(-1, real(0.1), 0)};
const vec3 lengths(1, 1, 0);  // of two orientations

}  // namespace

TEST_CASE("6.3 a gap of ten centimetres is closed by a move and a turn", "[6.3]") {
  // lever (-1, 0.1, 0), K lambda = -C gives lambda = (1/63, -13/315, 0) N s^2
  const vec3 none(0);
  check_vectors(point_table(), {"on paper", paper_point, paper},
                flat({none, none, vec3(1 / real(126), -13 / real(630), 0),
                      vec3(0, 0, 5 / real(63)), none, none, none, none, lengths}),
                10 * rounding);
}

TEST_CASE("6.3 a projection moves both bodies by M^-1 J^T lambda at every pose", "[6.3]") {
  check_vectors(point_table());
}

TEST_CASE("6.3 a projection touches no velocity and no static body", "[6.3]") {
  expect_left_alone(point_table());
}

TEST_CASE("6.3 a projection closes gaps of any size in all units", "[6.3]") {
  if (is_float) return;  // rounding would hide it
  check_drawn(point_projection, [](Draw& d) { return drawn_projection(d, false); });
}

// ---- 6.3 the rope -------------------------------------------------------------------------------

TEST_CASE("6.3 a rope that is too long is drawn to its length", "[6.3]") {
  // from (0, 0, 0) to (1.2, 0, 0), straight through the centre: all of it is a move
  const Rope<Distance> rope{{vec3(0), vec3(real(0.2), 0, 0), 1}};
  const vec3 none(0);
  check_vectors(rope_table(), {"on paper", rope, paper},
                flat({none, none, vec3(real(-0.2), 0, 0), none, none, none, none, none, lengths}),
                10 * rounding);
}

TEST_CASE("6.3 a rope moves both bodies where it is too long and none where it is slack",
          "[6.3]") {
  check_vectors(rope_table());
  expect_left_alone(rope_table());
}

TEST_CASE("6.3 a rope is drawn to its length from any distance in all units", "[6.3]") {
  if (!is_float) check_drawn(rope_projection, [](Draw& d) { return drawn_projection(d, true); });
}

// ---- 6.3 the iteration --------------------------------------------------------------------------

TEST_CASE("6.3 in an iteration each joint is projected at the poses after the one before it",
          "[6.3]") {
  iteration_table().check();
}

TEST_CASE("6.3 an iteration projects every joint of a long chain", "[6.3]") {
  check_drawn(iteration_subject, drawn_iteration);
}

// ---- 6.4 ----------------------------------------------------------------------------------------

TEST_CASE("6.4 a spring of 9.55 Hz removes twenty gaps a second and yields by a third", "[6.4]") {
  const CaseTable<SoftRowCase> table = soft_row_table();
  table.check(soft_row_case(30 / std::numbers::pi, 1, 60), {20, 1.0 / 3});  // h omega is 1
}

TEST_CASE("6.4 a frequency and a damping ratio become a rate and a softness", "[6.4]") {
  soft_row_table().check();
}

TEST_CASE("6.4 a soft row has its two numbers in any step", "[6.4]") {
  check_drawn(soft_row_subject, drawn_soft_row);
}

// ---- 6.4 the iteration --------------------------------------------------------------------------

TEST_CASE("6.4 a soft joint pulls a body at rest by a part of its gap", "[6.4]") {
  // 3 kg at its centre, 20 mm off: -3/4 3 kg 20/s 0.02 m
  const Pair pair{static_body(vec3(0)), body_with(3, vec3(1), vec3(real(0.02), 0, 0))};
  const JointRows rows{jacobian_from_blocks(mat3(-1), mat3(0), mat3(1), mat3(0)),
                       mat3(1 / real(3)), vec3(real(0.02), 0, 0)};
  const vec3 none(0);
  check_vectors(soft_iteration_table(), {"on paper", rows, {20, 1 / real(3)}, none, pair},
                flat({vec3(real(-0.9), 0, 0), none, none, vec3(real(-0.3), 0, 0), none}),
                10 * rounding);
}

TEST_CASE("6.4 an iteration of a soft block yields to the impulse that it has already", "[6.4]") {
  check_vectors(soft_iteration_table());
}

TEST_CASE("6.4 an iteration of a soft block is right in all units", "[6.4]") {
  check_drawn(soft_iteration_subject, drawn_soft_iteration);
}

// ---- 6.4 the step -------------------------------------------------------------------------------

TEST_CASE("6.4 a soft step of a chain has its parts in their order", "[6.4]") {
  soft_step_table().check();
}

TEST_CASE("6.4 a weight on a soft joint sags by g over omega squared in any number of substeps",
          "[6.4]") {
  const auto likely = soft_step_table().likely();
  for (const int relax : {0, 1})
    for (const int substeps : {1, 4, 16}) {
      const Hanging weight{{10, 2, substeps, relax}, 1.0 / 60, vec3(0), vec3(0), {0, -1, 0}};
      const double sag = -double(gaps_of(weight, 600).back().y);
      expect_or_say(soft_step_subject, "sag [m], substeps " + std::to_string(substeps), sag,
                    1 / (400 * std::numbers::pi * std::numbers::pi), is_float ? 1e-5 : 1e-9,
                    likely);
    }
}

TEST_CASE("6.4 without relax iterations a gap swings as the formula of its spring says", "[6.4]") {
  const auto likely = soft_step_table().likely();
  for (const int substeps : {1, 4}) {
    const Hanging free{{5, real(0.1), substeps, 0}, 1.0 / 60, {1, 0, 0}};
    const auto yours = frequency_and_loss(gaps_of(free, 4), free.h);
    std::vector<vec3> right;
    for (int n = 1; n <= 4; ++n)
      right.push_back({real(gap_by_formula(free, n * substeps, 1, 0, 0)), 0, 0});
    const auto wanted = frequency_and_loss(right, free.h);
    const double close = is_float ? 1e-3 : 1e-9;
    expect_or_say(soft_step_subject, "frequency [Hz]", yours.first, wanted.first, close, likely);
    expect_or_say(soft_step_subject, "fraction of the energy lost per step", yours.second,
                  wanted.second, close, likely);
  }
}

TEST_CASE("6.4 with a relax iteration a gap closes and never swings", "[6.4]") {
  const auto likely = soft_step_table().likely();
  const Hanging torn{{10, real(0.5), 2, 1}, 1.0 / 60, {1, 0, 0}};
  double before = 1;
  for (const vec3& gap : gaps_of(torn, 20)) {
    expect_or_say(soft_step_subject, "gap after a step over the gap before it",
                  double(gap.x) / before, gap_by_formula(torn, 2, 1, 0, 0),
                  is_float ? 1e-3 : 1e-9, likely);
    before = double(gap.x);
  }
}

TEST_CASE("6.4 one joint moves by the formula with any settings", "[6.4]") {
  check_drawn(soft_step_subject, drawn_soft_step);
}
