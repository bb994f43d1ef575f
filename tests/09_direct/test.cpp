// The tests of chapter 9's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include "tests/09_direct/coupling_cases.h"
#include "tests/09_direct/factor_cases.h"
#include "tests/09_direct/newton_cases.h"
#include "tests/09_direct/order_cases.h"
#include "tests/09_direct/pivot_cases.h"
#include "tests/09_direct/side_cases.h"
#include "tests/09_direct/slowed_cases.h"
#include "tests/09_direct/solve_cases.h"
#include "tests/09_direct/time_cases.h"
#include "tests/checker/catch.h"

using namespace joints;
using namespace joints::testing;

// ---- 9.1 ----------------------------------------------------------------------------------------

TEST_CASE("9.1 two rods that pull at a mass of 1 kg from both sides are coupled by minus one",
          "[9.1]") {
  const CaseTable<CouplingCase> table = coupling_table();
  table.check(table.cases[0], padded({-1}, numbers_of_coupling));
}

TEST_CASE("9.1 a rod between two masses of 1 kg has two on the diagonal", "[9.1]") {
  const CaseTable<CouplingCase> table = coupling_table();
  table.check(table.cases[1], padded({2}, numbers_of_coupling));
}

TEST_CASE("9.1 rows that only turn are coupled by their angular halves", "[9.1]") {
  const CaseTable<CouplingCase> table = coupling_table();
  table.check(table.cases[2], padded({3}, numbers_of_coupling));
}

TEST_CASE("9.1 each entry grows by the rate of a row per unit impulse along a column", "[9.1]") {
  coupling_table().check();
}

TEST_CASE("9.1 blocks of light and of heavy bodies are coupled alike", "[9.1]") {
  check_drawn(coupling_table().subject, drawn_coupling);
}

// ---- 9.2 the factor -----------------------------------------------------------------------------

TEST_CASE("9.2 elimination leaves the pivots 2, 3/2 and 4/3 of the text's chain", "[9.2]") {
  const Numbers paper{0.5, -0.5, 2.0 / 3, -2.0 / 3, 0.75};
  factor_table().check(paper_chain(), padded(paper, numbers_of_factor));
}

TEST_CASE("9.2 the factor of chains and stars and rings has each product in its place", "[9.2]") {
  factor_table().check();
}

TEST_CASE("9.2 the factor of a hundred nodes is as right as that of three", "[9.2]") {
  check_drawn({"9.2", "the factor L D L^T"}, drawn_factor);
}

// ---- 9.2 solving --------------------------------------------------------------------------------

TEST_CASE("9.2 the text's chain with 4 on the right has the impulses 3, 2 and 1", "[9.2]") {
  const CaseTable<MatrixCase> table = solve_table();
  Numbers paper = table.right(paper_chain());
  for (std::size_t i = 0; i < 3; ++i) paper[i] = 3 - double(i);
  table.check(paper_chain(), paper);
}

TEST_CASE("9.2 one factor solves right side after right side as a dense solution does", "[9.2]") {
  solve_table().check();
}

TEST_CASE("9.2 a solution of a hundred nodes has the right side that was given", "[9.2]") {
  check_drawn({"9.2", "the solution x with the factor", 2}, drawn_solve);
}

TEST_CASE("9.2 each pivot comes with the original entry of its own row", "[9.2]") {
  for (const MatrixCase& c : dependent_cases()) check_originals(c);
}

TEST_CASE("9.2 a dependent row gets no impulse and the others are solved without it", "[9.2]") {
  for (const MatrixCase& c : dependent_cases())
    for (Numbers b : right_sides(c)) {
      b[std::size_t(c.dropped[0])] = 5;  // whatever is wanted of it
      check_whole(c, b, without_dropped(c, b));
    }
}

// ---- 9.3 ----------------------------------------------------------------------------------------

TEST_CASE("9.3 stars and paths and rings fill in no pair too many", "[9.3]") {
  for (const GraphCase& c : graph_cases())
    if (c.exactly) check_order(c);
}

TEST_CASE("9.3 nets and wheels and graphs at random are filled in as by the rule", "[9.3]") {
  for (const GraphCase& c : graph_cases())
    if (!c.exactly) check_order(c);
  CHECK(cost_of(net(6), right_order(net(6))).fill == 71);
}

TEST_CASE("9.3 hundreds of nodes are eliminated with hardly more fill than by the rule", "[9.3]") {
  check_drawn(order_subject, drawn_order);
}

// ---- 9.4 ----------------------------------------------------------------------------------------

TEST_CASE("9.4 a pivot of two has the inverse one half", "[9.4]") {
  pivot_table().check({"a pivot of its whole entry", 2, 2}, {1});
}


TEST_CASE("9.4 a rounding error is a fraction of the pivot's own original entry", "[9.4]") {
  pivot_table().check();
}

TEST_CASE("9.4 a machine of nanograms has the same dependent rows as one of a million tonnes",
          "[9.4]") {
  check_drawn(pivot_table().subject, drawn_pivots, 1e-6);
}

// ---- 9.5 ----------------------------------------------------------------------------------------

TEST_CASE("9.5 a stone falls five centimetres in its first tenth of a second", "[9.5]") {
  World world;
  fall(world);
  SequentialImpulses solver;
  const double heights[] = {-0.05, -0.2, -0.45};  // -1/2 g t^2 with g = 10 m/s^2
  for (int n = 0; n < 3; ++n) {
    second_order_step(world, solver, real(0.1));
    const std::string after = " after step " + std::to_string(n + 1);
    expect_time("v.y" + after, double(world.bodies.at(0).v.y), -0.5 - n, rounding);
    expect_time("x.y" + after, double(world.bodies.at(0).x.y), heights[n], rounding);
  }
}

TEST_CASE("9.5 the step is that of the engine with leapfrog", "[9.5]") { time_table().check(); }

TEST_CASE("9.5 chains of any length fall in any direction and in any units", "[9.5]") {
  check_drawn(time_subject, drawn_time);
}

TEST_CASE("9.5 the step is made of its parts and does not call the engine's step", "[9.5]") {
  check_parts();
}

// ---- 9.6 ----------------------------------------------------------------------------------------

TEST_CASE("9.6 a slider at 3 m/s needs 5 m/s to be at its mark in a tenth of a second", "[9.6]") {
  const NewtonCase c = newton_cases()[0];
  Bodies bodies = newton_bodies(c);
  const auto corrector = c.corrector(bodies);
  std::vector<Body> start;
  const bool arrived = move_onto_constraints(bodies, 0.1, 4, c.tolerance, *corrector, start);
  expect_newton("result (0 false, 1 true)", arrived, 1, 0);
  expect_newton("x.x", double(bodies.at(1).x.x), 0.5, rounding);
  expect_newton("v.x", double(bodies.at(1).v.x), 5, 10 * rounding);
  expect_newton("calls of errors()", corrector->asked, 2, 0);
  expect_newton("calls of change_rates()", corrector->changed, 1, 0);
}

TEST_CASE("9.6 each iteration computes errors at the new poses, changes the velocities and goes "
          "back",
          "[9.6]") {
  newton_table().check();
}

TEST_CASE("9.6 any number of bodies and rows arrive after any number of iterations", "[9.6]") {
  if (!is_float) check_drawn(newton_subject, drawn_newton);
}

// ---- 9.7 ----------------------------------------------------------------------------------------

TEST_CASE("9.7 a contact that would pull goes to its lower bound and one that presses stays free",
          "[9.7]") {
  const double unlimited = std::numeric_limits<double>::infinity();
  side_table().check({"", Side::free, -0.5, 0, unlimited, 0}, {-1});
  side_table().check({"", Side::free, 0.5, 0, unlimited, 0}, {0});
}

TEST_CASE("9.7 a contact without an impulse is free again as soon as its bodies approach",
          "[9.7]") {
  const double unlimited = std::numeric_limits<double>::infinity();
  side_table().check({"", Side::lower, 0, 0, unlimited, -2}, {0});
  side_table().check({"", Side::lower, 0, 0, unlimited, 2}, {-1});
}

TEST_CASE("9.7 friction at its upper bound stays there while it slides and is free when it turns",
          "[9.7]") {
  side_table().check({"", Side::upper, 3, -3, 3, -2}, {1});
  side_table().check({"", Side::upper, 3, -3, 3, 2}, {0});
}

TEST_CASE("9.7 impulse and rate decide on the side, and at equality nothing flips", "[9.7]") {
  side_table().check();
}

TEST_CASE("9.7 a row changes sides at its bound and not near it in any units", "[9.7]") {
  check_drawn(side_table().subject, drawn_side);
}

// ---- 9.8 ----------------------------------------------------------------------------------------

TEST_CASE("9.8 one moment of three is less than the step can follow", "[9.8]") {
  slowed_table().check(paper_slowed(), {1.0 / 4, 1.0 / 4, 1.0 / 4, 3, 3, 2});
}

TEST_CASE("9.8 each moment becomes what the step can follow at every orientation", "[9.8]") {
  slowed_table().check();
}

TEST_CASE("9.8 a crate of a gram and one of a tonne are slowed alike", "[9.8]") {
  check_drawn(slowed_table().subject, drawn_slowed);
}

