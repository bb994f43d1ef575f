// The tests of chapter 6's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include "tests/06_baumgarte/baumgarte_cases.h"
#include "tests/06_baumgarte/drawn_cases.h"
#include "tests/06_baumgarte/safety_cases.h"
#include "tests/checker/catch.h"
#include "tests/checker/named.h"
#include "tests/06_baumgarte/torn_joints.h"

using namespace joints;
using namespace joints::testing;

// ---- 6.1 ----------------------------------------------------------------------------------------

TEST_CASE("6.1 a gap of two centimetres is closed at eighteen centimetres a second", "[6.1]") {
  bias_table().check(bias_case(0.02, 0.15, 60), {0.18});
}

TEST_CASE("6.1 the bias is a fraction of the error over the step", "[6.1]") {
  bias_table().check();
}

TEST_CASE("6.1 a row that is solved exactly keeps the fraction 1 - beta of its error", "[6.1]") {
  const CaseTable<BiasCase> table = bias_table();
  for (const double rate : {60.0, 100.0})
    for (const double beta : {0.15, 0.5, 1.0, 1.5}) {
      const real h = real(1 / rate);
      Bead bead(0.3, 4);
      double C = 0.3;
      for (int n = 1; n <= 4; ++n) {
        bead.step(bias(bead.body.x.x, real(beta), h), h, false);
        C *= 1 - beta;
        const double yours = double(bead.body.x.x);
        expect(table.subject, "C after steps: " + std::to_string(n) + ", beta " +
               short_number(beta), yours, C, 10 * rounding, table.explain(yours));
      }
    }
}

TEST_CASE("6.1 a limit that is passed comes back softly and one ahead is just reached", "[6.1]") {
  const CaseTable<BiasCase> table = limit_bias_table();
  table.check(bias_case(-0.02, 0.15, 60), {-0.18});
  table.check(bias_case(0.02, 0.15, 60), {1.2});
  table.check(bias_case(0, 0.15, 60), {0});
  table.check();
}

TEST_CASE("6.1 a body that runs into a limit lands on it and is never pulled", "[6.1]") {
  const CaseTable<BiasCase> table = limit_bias_table();
  const real h = real(1) / 60;
  const double beta = 0.15;
  struct Run {
    const char* words;
    double C, v, after;
  };
  const Run runs[] = {{"runs into it", 0.02, -5, 0},
                      {"just reaches it", 0.02, -1.2, 0},
                      {"comes nearer slowly", 0.02, -0.6, 0.01},
                      {"rests before it", 0.02, 0, 0.02},
                      {"runs away from it", 0.02, 3, 0.07},
                      {"is beyond it at rest", -0.02, 0, -0.02 * (1 - beta)},
                      {"runs on beyond it", -0.02, -5, -0.02 * (1 - beta)},
                      {"comes back by itself", -0.02, 0.6, -0.01}};
  for (const Run& run : runs) {
    Bead bead(run.C, run.v);
    bead.step(limit_bias(bead.body.x.x, real(beta), h), h, true);
    const double yours = double(bead.body.x.x);
    expect(table.subject, std::string("C (") + run.words + ")", yours, run.after,
           10 * rounding, table.explain(yours));
  }
}

TEST_CASE("6.1 a half-time of six steps removes eleven percent per step", "[6.1]") {
  half_time_table().check(half_time_case(0.1, 60), {0.109101281859661});  // 1 - 2^(-1/6)
}

TEST_CASE("6.1 beta for a half-time follows the step", "[6.1]") { half_time_table().check(); }

TEST_CASE("6.1 half of an error remains after the half-time for any step", "[6.1]") {
  const CaseTable<HalfTimeCase> table = half_time_table();
  const double half_time = 0.1;
  for (const int steps : {1, 2, 6, 10, 100}) {
    double C = 1;
    for (int n = 0; n < steps; ++n) C *= 1 - double(beta_for(real(half_time),
                                                             real(half_time / steps)));
    expect(table.subject, "C after 0.1 s, steps: " + std::to_string(steps), C, 0.5,
           is_float ? 1e-4 : 1e-11, table.explain(C));
  }
}

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

TEST_CASE("6.2 a warm start adds no linear or angular momentum to the two bodies", "[6.2]") {
  const CaseTable<WarmCase> table = warm_table();
  for (const WarmCase& c : table.cases) {
    if (c.pair.body1.is_static()) continue;
    vec3 lambda = c.lambda, push(0), turn(0);
    Pair after = c.pair;
    warm_start(c.J, real(c.ratio), lambda, after.body1, after.body2);
    const auto add = [&](const Body& before, const Body& body) {
      const vec3 change = (body.v - before.v) / before.inverse_mass;
      push += change;
      turn += cross(body.x, change) + inverse(inverse_inertia(body)) * (body.w - before.w);
    };
    add(c.pair.body1, after.body1);
    add(c.pair.body2, after.body2);
    const double tolerance = is_float ? 5e-3 : 1e-8;  // J is by differences, the lever is long
    expect(table.subject, "momentum added", push, vec3(0), tolerance, why(table, push));
    expect(table.subject, "angular momentum added", turn, vec3(0), tolerance, why(table, turn));
  }
}

TEST_CASE("6.2 a weight that hangs at rest stays at rest when the step changes", "[6.2]") {
  // every step takes m g h: the joint's last impulse times h/h_before is the next one's
  const CaseTable<WarmCase> table = warm_table();
  const Jacobian<3> J = jacobian_from_blocks(mat3(-1), mat3(0), mat3(1), mat3(0));
  Body wall = static_body(vec3(0)), weight = body_with(3, vec3(1), vec3(0));
  real before = real(1) / 60;
  vec3 lambda(0, 3 * real(9.81) * before, 0);
  for (const real h : {real(1) / 60, real(1) / 120, real(1) / 50, real(1) / 50}) {
    weight.v -= vec3(0, h * real(9.81), 0);
    warm_start(J, h / before, lambda, wall, weight);
    before = h;
    expect(table.subject, "v of the weight, h 1/" + short_number(1 / double(h)), weight.v, vec3(0),
           10 * rounding, why(table, weight.v));
  }
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

// "all of the gap", "a 100th of the gap": how much of it a projection starts with.
std::string part_of(int part, const std::string& what) {
  return part == 1 ? "all of " + what
                   : (part == 2 ? "half" : "a " + std::to_string(part) + "th") + " of " + what;
}

}  // namespace

TEST_CASE("6.3 a gap of ten centimetres is closed by a move and a turn", "[6.3]") {
  // lever (-1, 0.1, 0), K lambda = -C gives lambda = (1/63, -13/315, 0) N s^2
  const vec3 none(0);
  check_vectors(point_table(), {"on paper", paper_point, paper},
                flat({none, none, vec3(1 / real(126), -13 / real(630), 0),
                      vec3(0, 0, 5 / real(63)), none, none, none, none}), 10 * rounding);
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

TEST_CASE("6.3 the remaining gap after a projection falls with the square of the gap", "[6.3]") {
  const CaseTable<ProjectionCase<Point>> table = point_table();
  for (ProjectionCase<Point> c : table.cases) {
    const vec3 gap = c.part.error(c.pair.body1, c.pair.body2);
    for (const int part : {1, 2, 10, 100}) {
      ProjectionCase<Point> torn = c;
      torn.pair.body1.x += (1 - 1 / real(part)) * gap;
      const Pair after = projected(torn);
      const double left = length(torn.part.error(after.body1, after.body2));
      const double most = bend(torn, after) + rounding / 10;
      expect(table.subject, "gap left, at most (" + c.words + ", " + part_of(part, "the gap") + ")",
             std::max(left, most), most, 0, why_left(table, torn, after, left));
    }
  }
}

TEST_CASE("6.3 one projection after another closes a joint to the last digits", "[6.3]") {
  const CaseTable<ProjectionCase<Point>> table = point_table();
  for (ProjectionCase<Point> c : table.cases) {
    for (int n = 0; n < 6; ++n) c.pair = projected(c);
    const vec3 gap = c.part.error(c.pair.body1, c.pair.body2);
    expect(table.subject, "gap after 6 projections (" + c.words + ")", gap, vec3(0), rounding,
           why(table, gap));
  }
}

TEST_CASE("6.3 the common centre of mass stays where it is", "[6.3]") {
  const CaseTable<ProjectionCase<Point>> table = point_table();
  for (const ProjectionCase<Point>& c : table.cases) {
    if (c.pair.body1.is_static() || c.pair.body2.is_static()) continue;
    const real m1 = 1 / c.pair.body1.inverse_mass, m2 = 1 / c.pair.body2.inverse_mass;
    const auto centre = [&](const Pair& at) {
      return (m1 * at.body1.x + m2 * at.body2.x) / (m1 + m2);
    };
    const vec3 yours = centre(projected(c));
    expect(table.subject, "centre of mass (" + c.words + ")", yours, centre(c.pair),
           rounding, why(table, yours));
  }
}

// ---- 6.3 the rope -------------------------------------------------------------------------------

TEST_CASE("6.3 a rope that is too long is drawn to its length", "[6.3]") {
  // from (0, 0, 0) to (1.2, 0, 0), straight through the centre: all of it is a move
  const Rope<Distance> rope{{vec3(0), vec3(real(0.2), 0, 0), 1}};
  const vec3 none(0);
  check_vectors(rope_table(), {"on paper", rope, paper},
                flat({none, none, vec3(real(-0.2), 0, 0), none, none, none, none, none}),
                10 * rounding);
}

TEST_CASE("6.3 a rope moves both bodies where it is too long and none where it is slack",
          "[6.3]") {
  check_vectors(rope_table());
  expect_left_alone(rope_table());
}

TEST_CASE("6.3 a slack or taut rope does not change the bodies to the last bit", "[6.3]") {
  const CaseTable<ProjectionCase<Rope<Distance>>> table = rope_table();
  std::vector<ProjectionCase<Rope<Distance>>> cases = table.cases;
  cases.push_back({"taut", {{vec3(0), vec3(real(0.25), 0, 0), real(1.25)}}, paper});
  for (const auto& c : cases) {
    if (c.part.error(c.pair.body1, c.pair.body2) < 0) continue;
    const Pair after = projected(c);
    const auto same = [&](const Body& before, const Body& body, const std::string& number) {
      expect(table.subject, "x" + number + " (" + c.words + ")", body.x, before.x, 0,
             why(table, body.x));
      expect(table.subject, "q" + number + " (" + c.words + ")", body.q, before.q, 0);
    };
    same(c.pair.body1, after.body1, "1");
    same(c.pair.body2, after.body2, "2");
  }
}

TEST_CASE("6.3 the error of a rope after a projection is of second order", "[6.3]") {
  const CaseTable<ProjectionCase<Rope<Distance>>> table = rope_table();
  for (const ProjectionCase<Rope<Distance>>& c : table.cases) {
    const real excess = -c.part.error(c.pair.body1, c.pair.body2);
    for (const int part : {1, 10, 100}) {
      if (excess <= 0) continue;
      ProjectionCase<Rope<Distance>> rope = c;
      rope.part.rod.length += (1 - 1 / real(part)) * excess;
      const Pair after = projected(rope);
      const double left = std::abs(double(rope.part.error(after.body1, after.body2)));
      const double most = bend(rope, after) + rounding / 10;
      expect(table.subject, "error left, at most (" + c.words + ", " + part_of(part, "C") + ")",
             std::max(left, most), most, 0, why_left(table, rope, after, left));
    }
  }
}

TEST_CASE("6.3 a rope is drawn to its length from any distance in all units", "[6.3]") {
  if (!is_float) check_drawn(rope_projection, [](Draw& d) { return drawn_projection(d, true); });
}

// ---- 6.3 the iteration
// ------------------------------------------------------------------------------

TEST_CASE("6.3 in an iteration each joint is projected at the poses after the one before it",
          "[6.3]") {
  const Chain start = torn_chain();
  Chain yours = start, right = start;
  project_all(right, {0, 1, 2, 3}, reference_projection);
  projection_iteration(yours);
  const IterationMistake mistake = explain_iteration(start, yours);
  for (std::size_t k = 0; k < start.bodies.size(); ++k) {
    const Body &mine = yours.bodies[k], &other = right.bodies[k];
    const std::string number = " of body " + std::to_string(k);
    std::vector<VectorSuspect> x_or_v;
    std::vector<QuatSuspect> q;
    if (!mistake.words.empty()) {
      x_or_v = {{mine.x, mistake.words}, {mine.v, mistake.words}};
      q = {{mine.q, mistake.words}};
    }
    expect(mistake.subject, "x" + number, mine.x, other.x, difference_tolerance, x_or_v);
    expect(mistake.subject, "q" + number, mine.q, other.q, difference_tolerance, q);
    expect(mistake.subject, "v" + number, mine.v, start.bodies[k].v, 0, x_or_v);
  }
}

TEST_CASE("6.3 iteration after iteration a torn chain closes", "[6.3]") {
  const Chain start = torn_chain();
  Chain chain = start;
  projection_iteration(chain);
  const IterationMistake mistake = explain_iteration(start, chain);
  for (int n = 1; n < 400 && largest_gap(chain) < 10; ++n) projection_iteration(chain);
  for (std::size_t k = 0; k < chain.joints.size(); ++k) {
    const vec3 gap = chain.joints[k].error(chain.bodies[k], chain.bodies[k + 1]);
    std::vector<VectorSuspect> suspects;
    if (!mistake.words.empty()) suspects.push_back({gap, mistake.words});
    expect(mistake.subject, "gap of joint " + std::to_string(k) + " in the end", gap, vec3(0),
           rounding, suspects);
  }
}

TEST_CASE("6.3 an iteration projects every joint of a long chain", "[6.3]") {
  check_drawn(iteration_subject, drawn_iteration);
}

// ---- what the tests know of mistakes ------------------------------------------------------------

TEST_CASE("each usual mistake of chapter 6 is called by its name") {
  are_sound(bias_table(), limit_bias_table(), half_time_table(), warm_table(), safety_table(),
            point_table(), rope_table());
}
