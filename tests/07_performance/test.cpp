// The tests of chapter 7's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include "tests/checker/catch.h"
#include "tests/07_performance/drawn_cases.h"
#include "tests/07_performance/lane_cases.h"
#include "tests/07_performance/solve_path.h"

using namespace joints;
using namespace joints::testing;

namespace {
constexpr const char* by_hand = "by hand ";
}

// ---- 7.1 ----------------------------------------------------------------------------------------

TEST_CASE("7.1 the hinge of the text has one lever of two metres and none", "[7.1]") {
  check_numbers(lever_table(), paper_hinge(), {0, 0, 0, 0, 0, -2}, by_hand);
}

TEST_CASE("7.1 a lever turns with its body", "[7.1]") { check_numbers(lever_table()); }

TEST_CASE("7.1 an axis along x is held by rows along -z and y", "[7.1]") {
  check_numbers(axis_row_table(), paper_hinge(), {0, 0, -1, 0, 1, 0}, by_hand);
}

TEST_CASE("7.1 the axis rows are the slopes of the axis error as body 2 turns", "[7.1]") {
  check_numbers(axis_row_table());
}

TEST_CASE("7.1 a body without a direction keeps its inverse inertia", "[7.1]") {
  check_numbers(inertia_table(), paper_hinge(), {1, 1, 1, 0, 0, 0, 2, 2, 2, 0, 0, 0}, by_hand);
}

TEST_CASE("7.1 an inverse inertia turns with its body", "[7.1]") { check_numbers(inertia_table()); }

TEST_CASE("7.1 a slip of six centimetres is fed back at 0.72 m/s", "[7.1]") {
  check_numbers(hinge_bias_table(), paper_hinge(), {0.36, 0, 0.72, 0, 0}, by_hand);
}

TEST_CASE("7.1 the biases are a fraction of all five errors over the step", "[7.1]") {
  check_numbers(hinge_bias_table());
}

TEST_CASE("7.1 biases and levers are right for errors of any size", "[7.1]") {
  if (!is_float) check_drawn({"7.1", "the numbers of a hinge"}, drawn_hoist);
}

TEST_CASE("7.1 hoist does not change the inverse of K", "[7.1]") {
  HingeNumbers<real> out;
  for (int n = 0; n < 15; ++n) out.inverse_K[n] = real(1) + n;
  const HingeCase c = hinge_cases()[6];
  hoist(c.hinge, c.pair.body1, c.pair.body2, c.h, out);
  const char* const elsewhere = "#inverse-k-filled inverse_K stays as it is: K comes with "
                                "exercise 7.2, and the loop inverts it";
  for (int n = 0; n < 15; ++n) {
    const double yours = double(out.inverse_K[n]);
    expect({"7.1", "the parts that hoist must not "
                   "change"}, "inverse_K[" + std::to_string(n) + "]", yours,
           1 + n, 0,
           {{0, std::string("all of out is set to zero, or replaced: ") + elsewhere},
            {yours, elsewhere}});
  }
}

// ---- 7.2 ----------------------------------------------------------------------------------------

TEST_CASE("7.2 the hinge of the text couples x with its second axis row", "[7.2]") {
  check_numbers(whole_K_table(), paper_hinge(),
                {9.5, 0, 0, 0, -4, 0, 9.5, 0, 0, 0, 0, 0, 1.5, 0, 0, 0, 0, 0, 3, 0, -4, 0, 0, 0, 3},
                by_hand);
}

TEST_CASE("7.2 the closed form is J M^-1 J^T at every pose", "[7.2]") {
  check_numbers(whole_K_table());
}

TEST_CASE("7.2 the closed form is right in all units and beside a wall", "[7.2]") {
  check_drawn(whole_K_table().subject, drawn_whole_K);
}

// ---- 7.3 ----------------------------------------------------------------------------------------

TEST_CASE("7.3 a chain takes two colours in turn", "[7.3]") {
  check_colours(chain_scene(4, true), {0, 1, 0, 1});
  check_colours(chain_scene(7, false), {0, 1, 0, 1, 0, 1, 0});
}

TEST_CASE("7.3 a star takes as many colours as it has arms", "[7.3]") {
  check_colours(star_scene(6, true), {0, 1, 2, 3, 4, 5});
}

TEST_CASE("7.3 any number of joints may hold to the same wall at once", "[7.3]") {
  check_colours(star_scene(6, false), {0, 0, 0, 0, 0, 0});
}

TEST_CASE("7.3 a ring of an odd number of joints takes a third colour", "[7.3]") {
  check_colours(ring_scene(6), {0, 1, 0, 1, 0, 1});
  check_colours(ring_scene(7), {0, 1, 0, 1, 0, 1, 2});
}

TEST_CASE("7.3 no two joints of a colour hold the same body that moves", "[7.3]") {
  for (const ColourScene& scene : colour_scenes()) {
    const Colours yours = your_colours(scene);
    if (yours.size() != scene.links.size()) check_colours(scene, right_colours(scene));
    for (std::size_t k = 0; k < yours.size(); ++k)
      for (std::size_t before = 0; before < k; ++before)
        if (yours[k] == yours[before] && share_a_body(scene, scene.links[k], scene.links[before]))
          fail_colours(scene, "Both have the colour " + std::to_string(yours[k]) + ": " +
                                  joint_words(scene, before) + " and " + joint_words(scene, k) +
                                  ".\n");
    check(colours_subject, "");
  }
}

TEST_CASE("7.3 every joint has the least colour that is free after the joints before it", "[7.3]") {
  for (const ColourScene& scene : colour_scenes()) check_colours(scene, right_colours(scene));
}

TEST_CASE("7.3 hundreds of joints at a body take hundreds of colours", "[7.3]") {
  check_drawn(colours_subject, drawn_colours, 1e-9, 25);
}

TEST_CASE("7.3 nothing is read or written outside a vector", "[7.3]") {
  for (const ColourScene& scene : colour_scenes()) {
    if (const std::string words = outside(scene); !words.empty())
      fail(colours_subject, "Scene: " + scene.words + ".\n\n" + likely(words));
    check(colours_subject, "");
  }
}

// ---- 7.4 ----------------------------------------------------------------------------------------

TEST_CASE("7.4 the hinge of the text is closed by one solve", "[7.4]") {
  const double third = 1.0 / 3;
  check_solve(solve_case(paper_hinge()),
              {0.0552, 4.0 / 95, 0.34, 0, 0.1472, third, -0.0104, -27.0 / 95, -0.38, 31.0 / 190,
               0.1472, third}, by_hand);
}

TEST_CASE("7.4 a solve changes the velocities by M^-1 J^T lambda at every pose", "[7.4]") {
  for (const SolveCase& c : solve_cases())
    check_solve(c, flat(SolveReference(c).solved()), "numeric ");
}

TEST_CASE("7.4 a solve does not change the inverse masses", "[7.4]") {
  for (const SolveCase& c : solve_cases()) {
    const SolveCase after = solved(c);
    const auto compare = [&](const std::string& body, const Velocities<real>& yours,
                             const Velocities<real>& right) {
      expect({"7.4", "the parts that a solve must not change"}, "inverse mass of " + body,
             double(yours.inverse_mass), double(right.inverse_mass), 0,
             {{0, "the record is replaced without its inverse mass: change v and w alone"},
              {double(yours.inverse_mass), "it stays as it is: change v and w alone"}});
    };
    compare("body 1 (" + c.words + ")", after.body1, c.body1);
    compare("body 2 (" + c.words + ")", after.body2, c.body2);
  }
}

// ---- 7.4 on lanes -------------------------------------------------------------------------------

TEST_CASE("7.4 each lane gives the digits of a single hinge", "[7.4]") {
  const std::vector<SolveCase> cases = solve_cases();
  for (std::size_t first = 0; first < cases.size(); ++first) {
    LaneCase all = on_lanes(first);
    solve_lanes(all);
    for (int lane = 0; lane < lane_count; ++lane) {
      const SolveCase& c = cases[(first + std::size_t(lane)) % cases.size()];
      expect_lane(lane, " (" + c.words + ")", lane_velocities(all, lane),
                  velocities_of(solved(c)), rounding, velocities_of(c),
                  "the numbers of another lane: with + - * of Number each stays in its own");
    }
  }
}
