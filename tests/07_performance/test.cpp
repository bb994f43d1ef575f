// The tests of chapter 7's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include "tests/checker/catch.h"
#include "tests/checker/named.h"
#include "tests/07_performance/drawn_cases.h"
#include "tests/07_performance/hoist_bias_cases.h"
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

TEST_CASE("7.1 the hoisted numbers do not depend on the velocities", "[7.1]") {
  for (const HingeCase& c : hinge_cases()) {
    HingeCase at_rest = c;
    for (Body* body : {&at_rest.pair.body1, &at_rest.pair.body2}) body->v = body->w = vec3(0);
    const HingeNumbers<real> flying = hoisted(c), resting = hoisted(at_rest);
    const auto compare = [&](const std::string& name, real one, real other) {
      expect({"7.1", "the numbers of a hinge, its bodies at rest and flying"},
             name + " (" + c.words + ")", double(one), double(other), 0,
             {{double(one), "the velocities are included: they change in every solve, so nothing "
                            "that depends on them may be stored"}});
    };
    compare("r1.x", flying.r1.x, resting.r1.x);
    compare("r2.x", flying.r2.x, resting.r2.x);
    compare("axis_row[0].x", flying.axis_row[0].x, resting.axis_row[0].x);
    compare("axis_row[1].x", flying.axis_row[1].x, resting.axis_row[1].x);
    compare("I1.xx", flying.I1.xx, resting.I1.xx);
    compare("I2.xx", flying.I2.xx, resting.I2.xx);
    for (int i = 0; i < 5; ++i)
      compare("bias[" + std::to_string(i) + "]", flying.bias[i], resting.bias[i]);
  }
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
  check_drawn(whole_K_subject, drawn_whole_K);
}

TEST_CASE("7.2 an impulse along a row changes the rates of all rows by a column of K", "[7.2]") {
  CaseTable<HingeCase> table = whole_K_table();
  for (const HingeCase& c : table.cases) {
    Matrix<5> right;
    for (int j = 0; j < 5; ++j) {
      const Vector<5> rates = rates_after_an_impulse(c, j);
      for (int i = 0; i < 5; ++i) right[i][j] = rates[std::size_t(i)];
    }
    check_numbers(table, c, numbers_of(right, -1), "numeric ");
  }
}

TEST_CASE("7.2 two rows change each other's rates equally", "[7.2]") {
  for (const HingeCase& c : hinge_cases()) {
    const Matrix<5> K = your_K(c);
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < i; ++j)
        expect(whole_K_subject,
               "K[" + five_rows[std::size_t(i)] + ", " + five_rows[std::size_t(j)] +
                   "] beside its mirror (" + c.words + ")",
               double(K[i][j]), double(K[j][i]), 10 * rounding,
               {{double(K[i][j]), "K is symmetric: the entries above its diagonal are repeated "
                                  "below it"}});
  }
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

TEST_CASE("7.3 the order of the joints decides and may cost a colour", "[7.3]") {
  check_colours({"a chain whose ends come first", {{0, 1}, {3, 4}, {1, 2}, {2, 3}},
                 {true, true, true, true, true}},
                {0, 0, 1, 2});
}

TEST_CASE("7.3 no joints take no colours and a body without joints changes none",
          "[7.3]") {
  check_colours({"nothing at all", {}, {}}, {});
  check_colours({"bodies without joints", {}, {true, false, true}}, {});
  check_colours({"bodies that no joint names", {{1, 4}, {4, 6}},
                 {true, true, true, false, true, true, true, true}},
                {0, 1});
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

TEST_CASE("7.3 at most 2 d - 1 colours are taken where no body has more than d joints", "[7.3]") {
  for (const ColourScene& scene : colour_scenes()) {
    std::vector<int> joints(scene.moves.size(), 0);
    for (const BodyPair& link : scene.links)
      for (const int body : {link.body1, link.body2}) joints[std::size_t(body)] += 1;
    int d = 1;
    for (std::size_t body = 0; body < joints.size(); ++body)
      if (scene.moves[body]) d = std::max(d, joints[body]);
    for (const int colour : your_colours(scene))
      if (colour < 0 || colour >= 2 * d - 1)
        fail_colours(scene, "There is a colour " + std::to_string(colour) + ", and " +
                                std::to_string(2 * d - 1) + " colours from 0 are enough.\n");
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

TEST_CASE("7.4 after one solve all five rows are satisfied", "[7.4]") {
  for (const SolveCase& c : solve_cases()) {
    const Vector<5> left = SolveReference(solved(c)).e();
    for (std::size_t i = 0; i < 5; ++i)
      expect_solved("e[" + std::to_string(i) + "] after the solve (" + c.words + ")",
                    double(left[i]), 0, loose);
  }
}

TEST_CASE("7.4 a solve adds no linear or angular momentum to two bodies that move", "[7.4]") {
  for (const SolveCase& c : solve_cases()) {
    if (c.body1.inverse_mass == 0 || c.body2.inverse_mass == 0) continue;
    const Momentum before(c, c), after(solved(c), c);
    expect_solved("momentum (" + c.words + ")", after.push, before.push, loose);
    expect_solved("angular momentum (" + c.words + ")", after.turn, before.turn, loose);
  }
}

TEST_CASE("7.4 a solve without a bias never adds energy", "[7.4]") {
  for (SolveCase c : solve_cases()) {
    for (real& b : c.hinge.bias) b = 0;
    const double before = Momentum(c, c).energy, after = Momentum(solved(c), c).energy;
    expect_solved("energy, at most (" + c.words + ")", std::max(before, after), before, loose);
  }
}

TEST_CASE("7.4 a static body keeps its velocities to the last bit", "[7.4]") {
  for (SolveCase c : solve_cases()) {
    for (Velocities<real>* body : {&c.body1, &c.body2})
      if (body->inverse_mass == 0) {  // a floor that drives past
        body->v = {real(0.1), real(-0.7), 3};
        body->w = {real(0.3), real(1) / 3, real(-0.9)};
      }
    const FourVelocities before = velocities_of(c), after = velocities_of(solved(c));
    const char* const names[] = {"v1", "w1", "v2", "w2"};
    for (std::size_t k = 0; k < 4; ++k)
      if ((k < 2 ? c.body1 : c.body2).inverse_mass == 0)
        expect_solved(std::string(names[k]) + " (" + c.words + ")", after[k], before[k], 0);
  }
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

TEST_CASE("7.4 a lane without finite numbers does not affect the others", "[7.4]") {
  for (const real bad : {std::numeric_limits<real>::quiet_NaN(), unbounded, real(1e30)})
    for (int spoilt = 0; spoilt < lane_count; ++spoilt) {
      LaneCase all = on_lanes(3), healthy = all;
      const LaneCase before = all;
      const auto v = reinterpret_cast<real*>(&all.body2);
      v[spoilt] = bad;  // v.x of body 2
      solve_lanes(all);
      solve_lanes(healthy);
      const std::string words = " beside a bad lane " + std::to_string(spoilt);
      const std::string mixed = "the lanes are mixed: nothing may pass from one to another";
      for (int lane = 0; lane < lane_count; ++lane) {
        if (lane == spoilt) continue;
        const FourVelocities yours = lane_velocities(all, lane);
        if (!all_finite(flat(yours)))
          fail(lanes_subject, "Lane " + std::to_string(lane) + words +
                                  " does not hold finite numbers.\n\n" + likely(mixed));
        expect_lane(lane, words, yours, lane_velocities(healthy, lane), 0,
                    lane_velocities(before, lane), mixed);
      }
    }
}

TEST_CASE("7.4 a lane that is not used stays zero", "[7.4]") {
  for (int unused = 0; unused < lane_count; ++unused) {
    LaneCase all = on_lanes(5, unused);
    solve_lanes(all);
    const FourVelocities zero{vec3(0), vec3(0), vec3(0), vec3(0)};
    const FourVelocities yours = lane_velocities(all, unused);
    expect_lane(unused, " that is not used", yours, zero, 0, zero,
                "a lane of zeros has no e, so no lambda: is there a constant, or a division?");
  }
}

// ---- what the tests know of mistakes ------------------------------------------------------------

TEST_CASE("each usual mistake with colours gives different colours") {
  CHECK(colour_mistakes_alike() == std::vector<std::string>{});
}

TEST_CASE("each usual mistake of chapter 7 is called by its name") {
  are_sound(lever_table(), axis_row_table(), inertia_table(), hinge_bias_table(), whole_K_table(),
            K_part_table(0), K_part_table(1), K_part_table(2), solve_table());
}
