// The tests of chapter 1's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include "engine/sequential_impulses.h"
#include "engine/steps/step.h"
#include "joints/distance_joint.h"
#include "tests/01_distance/clamp_cases.h"
#include "tests/01_distance/drawn_cases.h"
#include "tests/01_distance/row_cases.h"
#include "tests/01_distance/step_cases.h"
#include "tests/checker/catch.h"
#include "tests/checker/fixtures.h"

using namespace joints;
using namespace joints::testing;

// ---- 1.1 and 1.2 --------------------------------------------------------------------------------

TEST_CASE("1.1 the row of a rod points from centre to centre", "[1.1]") {
  check_jacobian<CentreDistanceFixture>({real(1.5)}, {rod_paper1, rod_paper2},
                                        to_jacobian(rod_paper_J));
}

TEST_CASE("1.1 the row of a rod is the slope of its length at every pose", "[1.1]") {
  check_jacobian<CentreDistanceFixture>();
}

TEST_CASE("1.1 a rod between centres that coincide has no direction and no row", "[1.1]") {
  const Row J = CentreDistance{1}.jacobian(rod_paper1, rod_paper1);
  expect(CentreDistanceFixture::J, "centres coincide: v2", J.v2, vec3(0), 0);
}

TEST_CASE("1.1 centres a hair apart still have a direction", "[1.1]") {
  const real hair = real(1e-9);
  const Body body = body_with(3, vec3(1), hair * vec3(real(0.6), real(0.8), 0));
  const Row J = CentreDistance{1}.jacobian(rod_paper1, body);
  expect(CentreDistanceFixture::J, "v2 where the centres are 1e-9 m apart", J.v2,
         vec3(real(0.6), real(0.8), 0), rounding,
         {{vec3(0), "#close-centres-taken-one the row is 0 where the centres are close: only "
                    "where they coincide there is no direction"}});
}

TEST_CASE("1.1 a rod beside a wall has both its blocks", "[1.1]") {
  const Row J = CentreDistance{1}.jacobian(static_body(vec3(0)), rod_paper2);
  expect(CentreDistanceFixture::J, "v1 where body 1 is static", J.v1,
         vec3(real(-0.6), real(-0.8), 0), rounding,
         {{vec3(0), "#nothing-wall a static body has its block in J, too: only its M^-1 is zero"}});
}

TEST_CASE("1.1 the row of a rod has a unit vector for every distance", "[1.1]") {
  check_drawn(CentreDistanceFixture::J, [](Draw& d) { return drawn_centres(d, false); });
}

TEST_CASE("1.2 an impulse along a rod of 2 and 3 kg changes its rate by K", "[1.2]") {
  check_K<CentreDistanceFixture>({real(1.5)}, {rod_paper1, rod_paper2}, to_matrix(real(5) / 6));
}

TEST_CASE("1.2 K of a rod is J M^-1 J^T at every pose", "[1.2]") {
  check_K<CentreDistanceFixture>();
}

TEST_CASE("1.2 a static body adds nothing to K", "[1.2]") {
  const Body wall = static_body(vec3(0));
  expect(CentreDistanceFixture::K, "K beside a wall",
         double(CentreDistance{2}.K(wall, rod_paper2)), 1.0 / 3, rounding,
         {{0, "#nothing-beside-wall K is 0 only where both bodies are static: the other one can "
              "move"}});
  const double walls = double(CentreDistance{2}.K(wall, static_body(vec3(1, 0, 0))));
  expect(CentreDistanceFixture::K, "K between two walls", walls, 0, 0,
         {{walls, "#one-between-two-walls between two walls K is 0: row_impulse handles this "
                  "case"}});
  const Body planet = body_with(real(1e20), vec3(1), vec3(1, 0, 0));
  expect(CentreDistanceFixture::K, "K of heavy bodies, 1e20 kg beside a wall, in 1e-20 / kg",
         1e20 * double(CentreDistance{2}.K(wall, planet)), 1, rounding);
}

TEST_CASE("1.2 K of a rod is the sum of both inverse masses for every mass", "[1.2]") {
  check_drawn(CentreDistanceFixture::K, [](Draw& d) { return drawn_centres(d, true); });
}

// ---- 1.3 ----------------------------------------------------------------------------------------

TEST_CASE("1.3 the impulse is the missing rate over K", "[1.3]") {
  const CaseTable<LackCase> table = row_impulse_table();
  table.check(table.cases[0], {-8.4});
  table.check(table.cases[1], {-1.2});
  table.check();
}

TEST_CASE("1.3 an impulse changes velocities by M^-1 J^T lambda", "[1.3]") {
  row_push_table().check();
}

TEST_CASE("1.3 the impulse is the missing rate over K for all masses and lengths and sides",
          "[1.3]") {
  check_drawn({"1.3", "the impulse of a row"}, drawn_row_impulse);
}

TEST_CASE("1.3 an impulse acts on each body that can move, however small it is", "[1.3]") {
  check_drawn({"1.3", "applying the impulse of a row", 2}, drawn_row_push);
}

// ---- 1.4 ----------------------------------------------------------------------------------------

TEST_CASE("1.4 free bodies fall by Euler's semi-implicit rule", "[1.4]") {
  const CaseTable<Scene> table = step_table(free_scenes());
  const double h = 1.0 / 60, g = -9.81;
  table.check(table.cases[0], filled_up({0, 3 * g * h, 0, 0, 6 * g * h * h, 0, 0, 0, 0, 1, 1, 1}));
  table.check();
}

TEST_CASE("1.4 a rod loses the fraction beta of its error and all velocity that changes its "
          "length", "[1.4]") {
  const CaseTable<Scene> table = step_table(rod_scenes());
  table.check(table.cases[0], filled_up({0, 0, 0, 0, 0, 0, -1.2, 0, 0, 1.07, 0, 0}));
  table.check(table.cases[2], filled_up({0, 0, 0, 0, 0, 0, 1, 0, 0, 0.025, -1, 0}));
  table.check();
}

TEST_CASE("1.4 the order is forces then rows then impulses then positions", "[1.4]") {
  const CaseTable<Scene> table = step_table(falling_rod_scenes());
  table.check(table.cases[0], filled_up({0, 0, 0, 0, 0, 0, 1, 0, 0, 1.0 / 60, -1, 0}));
  table.check();
}

TEST_CASE("1.4 a step does not rotate a body", "[1.4]") {
  std::vector<Body> bodies{static_body(vec3(0)), ball(2, 1, vec3(0, -1, 0))};
  bodies[1].w = vec3(1, 2, 3);
  step(bodies, {{0, 1, 1}}, {});
  expect({"1.4", "the step"}, "q of a body that spins", bodies[1].q, quat(1, 0, 0, 0), 0,
         {{rotation(vec3(1, 2, 3) / real(60)), "#bodies-turn-too the step turns the body: that is "
                                               "chapter 2"}});
}

TEST_CASE("1.4 a step is the same for any number of bodies and rods and in any units", "[1.4]") {
  check_drawn({"1.4", "the step"}, [](Draw& d) { return drawn_step(d, false); });
}

// ---- 1.5 ----------------------------------------------------------------------------------------

TEST_CASE("1.5 a rope may release its pull but never push", "[1.5]") {
  clamp_table().check();
}

TEST_CASE("1.5 a rope may release its pull in any unit of mass", "[1.5]") {
  check_drawn({"1.5", "the clamped sum of a rope"}, drawn_clamp);
}

// Once clamp_sum is right, the step is tested with ropes, too. What it gets wrong is 1.4's.
TEST_CASE("1.5 a step lets its ropes pull and not push", "[1.4][1.5]") {
  if (!clamp_is_right()) return;
  const CaseTable<Scene> table = rope_table();
  table.check(table.cases[0], filled_up({0, 0, 0, 0, 0, 0,
                               0, -9.81 / 60, 0, 0, -0.5 - 9.81 / 3600, 0}));
  table.check();
}

TEST_CASE("1.5 any number of ropes and rods pull together", "[1.4][1.5]") {
  if (clamp_is_right())
    check_drawn({"1.4", "the step"}, [](Draw& d) { return drawn_step(d, true); });
}

// ---- 1.6 ----------------------------------------------------------------------------------------

TEST_CASE("1.6 the row of a rod between anchors contains a lever", "[1.6]") {
  const Pair pair{static_body(vec3(0)), box(2, vec3(1), vec3(1, 0, 0))};
  const Distance rod{vec3(0), vec3(0, real(0.5), 0), 1};
  const real size = std::sqrt(real(5));
  const vec3 n(2 / size, 1 / size, 0);
  check_jacobian<DistanceFixture>(rod, pair,
                                  to_jacobian(Row{-n, vec3(0), n, vec3(0, 0, -1 / size)}));
}

TEST_CASE("1.6 the row of a rod between anchors is the slope of its length at every pose",
          "[1.6]") {
  check_jacobian<DistanceFixture>();
}

TEST_CASE("1.6 the row has both levers at any distance and beside a wall", "[1.6]") {
  check_drawn(DistanceFixture::J, [](Draw& d) { return drawn_rod(d, false); });
}

TEST_CASE("1.6 K of a rod between anchors has a term of the rotation in it", "[1.6]") {
  const Pair pair{static_body(vec3(0)), box(2, vec3(1), vec3(1, 0, 0))};
  check_K<DistanceFixture>({vec3(0), vec3(0, real(0.5), 0), 1}, pair, to_matrix(real(1.1)));
}

TEST_CASE("1.6 K of a rod between anchors is J M^-1 J^T at every pose", "[1.6]") {
  check_K<DistanceFixture>();
}

TEST_CASE("1.6 K is that of its row in any units and beside a wall", "[1.6]") {
  check_drawn(DistanceFixture::K, [](Draw& d) { return drawn_rod(d, true); });
}

TEST_CASE("1.6 a rod between points that coincide has no direction and no row", "[1.6]") {
  const Body cube1 = box(2, vec3(1), vec3(0)), cube2 = box(3, vec3(1), vec3(1, 0, 0));
  const Distance rod{vec3(real(0.5), 0, 0), vec3(real(-0.5), 0, 0), 1};
  const Row J = rod.jacobian(cube1, cube2);
  expect(DistanceFixture::J, "v2 where the points coincide", J.v2, vec3(0), rounding);
  const double K = double(rod.K(cube1, cube2));
  if (K != 0)  // with either K the impulse is 0
    expect(DistanceFixture::K, "K where the points coincide", K, 5.0 / 6, rounding);
}
