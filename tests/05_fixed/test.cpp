// The tests of chapter 5's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include "tests/05_fixed/break_cases.h"
#include "tests/05_fixed/cross_cases.h"
#include "tests/05_fixed/drawn_cases.h"
#include "tests/05_fixed/load_cases.h"
#include "tests/05_fixed/sleeve_cases.h"
#include "tests/checker/catch.h"

using namespace joints;
using namespace joints::testing;

// ---- 5.1 ----------------------------------------------------------------------------------------

TEST_CASE("5.1 a turning impulse of the lock moves the anchor of the point", "[5.1]") {
  // world inverse inertia diag(2, 2.5, 2.5), lever (0, 1, 1/2)
  check_numbers(cross_table(), paper_weld(), {0, 1.25, -2.5, -1, 0, 0, 2, 0, 0}, "by hand ");
}

TEST_CASE("5.1 X is the product of the point's rows and the lock's rows at every pose", "[5.1]") {
  check_numbers(cross_table());
}

TEST_CASE("5.1 X is right in all units and beside a wall", "[5.1]") {
  check_drawn({"5.1", "the matrix X"}, drawn_cross_K);
}

TEST_CASE("5.1 K of a weld is J M^-1 J^T of all six rows at every pose", "[5.1]") {
  std::vector<Sample> samples;
  for_each_pose<WeldFixture>([&](int pose, const Weld& weld, const Pair& pair) {
    Seen part = seen<WeldFixture>(weld);
    part.K = [weld](const Pair& at) { return flat(weld_K(weld, at.body1, at.body2)); };
    samples.push_back(K_sample(pose, part, pair, whole_K(part.slope(pair), pair)));
  });
  check(WeldFixture::K, K_report(row_names<WeldFixture>(), samples, K_tolerance),
        "effective masses", samples);
}

// ---- 5.2 ----------------------------------------------------------------------------------------

TEST_CASE("5.2 the load of a weld is its impulses over the time in which they acted", "[5.2]") {
  check_numbers(load_table(), {"pencil and paper", {0, real(0.5), 0, 0, 0, real(0.25)}, real(0.1)},
                {0, 5, 0, 0, 0, 2.5}, "by hand ");
  check_numbers(load_table());
}

TEST_CASE("5.2 the torque of a load is larger about a point farther from its line", "[5.2]") {
  check_numbers(about_table(),
                {"pencil and paper", {vec3(0, 5, 0), vec3(0, 0, real(2.5))}, vec3(1, 0, 0),
                 vec3(0)},
                {0, 0, 7.5, 0, 5, 0}, "by hand ");
  check_numbers(about_table());
}

TEST_CASE("5.2 a shelf of two kilograms bends its wall by its weight times its lever", "[5.2]") {
  // the centre hangs 1/2 m before the wall; the wall holds 19.62 N up and turns with 9.81 N m
  const vec3 centre(real(0.5), 0, 0), weight(0, real(19.62), 0);
  check_numbers(about_table(), {"a shelf, at its wall", {weight, vec3(0)}, centre, vec3(0)},
                {0, 0, 9.81, 0, 19.62, 0}, "by hand ");
  check_numbers(about_table(),
                {"a shelf, at its centre", {weight, vec3(0, 0, real(9.81))}, vec3(0), centre},
                {0, 0, 0, 0, 19.62, 0}, "by hand ");
}

TEST_CASE("5.2 a weld breaks when its force or its torque is too large", "[5.2]") {
  break_table().check();
}

TEST_CASE("5.2 a load is its impulses over the time, however small", "[5.2]") {
  check_drawn({"5.2", "the load of a weld"}, drawn_load);
  check_drawn({"5.2", "the load about another point", 2}, drawn_about);
}

TEST_CASE("5.2 a weld breaks just above a bound and not just below", "[5.2]") {
  if (!is_float) check_drawn({"5.2", "whether a weld breaks", 3}, drawn_breaks);
}

// ---- 5.3 ----------------------------------------------------------------------------------------

TEST_CASE("5.3 a sleeve on the shaft of the text has four rows, coupled in pairs", "[5.3]") {
  Numbers right{0, 0, 0, 0, 1.125, 0, -1.25, 0, 0, 3.5, 0, -1, -1.25, 0, 2.5, 0, 0, -1, 0, 2};
  const Numbers rows{0, -1, 0, 0, 0, -1,  0, 1, 0, 0,  0,    0.5,   // n1 = y
                     0, 0, -1, 0, 1, 0,   0, 0, 1, 1,  -0.5, 0,     // n2 = z
                     0, 0, 0,  0, 0, 1,   0, 0, 0, 0,  0,    -1,    // b x a1
                     0, 0, 0,  0, -1, 0,  0, 0, 0, 0,  1,    0};    // c x a1
  right.insert(right.end(), rows.begin(), rows.end());
  check_numbers(sleeve_table(), paper_sleeve(), right, "by hand ");
}

TEST_CASE("5.3 a sleeve slides and rotates, and its four rows are one block at every pose",
          "[5.3]") {
  check_numbers(sleeve_table());
}

TEST_CASE("5.3 the load of rows of any direction, about the centre and about a seam", "[5.3]") {
  check_numbers(transmitted_table(), paper_transmitted(), {0, 5, 0, 0, 0, 4.5}, "by hand ");
  check_numbers(transmitted_table());
}

TEST_CASE("5.3 block and load are right in all units", "[5.3]") {
  check_drawn({"5.3", "K of a sleeve"}, drawn_sleeve);
  check_drawn({"5.3", "the load of four rows", 2}, drawn_transmitted);
}
