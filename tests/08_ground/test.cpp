// The tests of chapter 8's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include "tests/checker/catch.h"
#include "tests/08_ground/contact_cases.h"
#include "tests/08_ground/drawn_cases.h"
#include "tests/08_ground/friction_cases.h"
#include "tests/08_ground/gap_cases.h"
#include "tests/08_ground/tangent_cases.h"

using namespace joints;
using namespace joints::testing;

namespace {

// The pose for pencil and paper in the chapter's text: a box turned by a quarter about z.
const real half = std::sqrt(real(0.5));
const vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
const Pair paper{static_body(vec3(0)), body_with(12, vec3(5, 2, 5), vec3(real(1.5), real(1.1), 0),
                                                 quat(half, 0, 0, half))};
const Corner paper_corner{vec3(real(-0.5), 1, real(0.5)), 0, real(0.5)};

}  // namespace

// ---- 8.1 the gap -------------------------------------------------------------------------------

TEST_CASE("8.1 the gap of the text's corner is ten centimetres", "[8.1]") {
  gap_table().check({"by hand", paper_corner, paper}, {0.1});
}

TEST_CASE("8.1 the gap of a corner is measured from the top along its own upright", "[8.1]") {
  gap_table().check();
}

// ---- 8.1 the rows -------------------------------------------------------------------------------

TEST_CASE("8.1 the normal row of the text's corner has levers of a metre and a half metre",
          "[8.1]") {
  check_jacobian<CornerFixture>(
      CornerReference{paper_corner}, paper,
      to_jacobian(Row{-y, vec3(real(0.5), 0, real(-0.5)), y, vec3(real(-0.5), 0, -1)}));
}

TEST_CASE("8.1 the rows of the text's corner along the ground and along n", "[8.1]") {
  check_jacobian<CornerSlides>(
      {paper_corner, {x, -z, y}}, paper,
      Jacobian<3>{{Row{-x, vec3(0, real(-0.5), real(0.6)), x, vec3(0, real(0.5), real(0.5))},
                   Row{z, vec3(real(0.6), real(-0.5), 0), -z, vec3(real(0.5), -1, 0)},
                   Row{-y, vec3(real(0.5), 0, real(-0.5)), y, vec3(real(-0.5), 0, -1)}}});
}

TEST_CASE("8.1 the row of a corner is the slope of its gap at every pose", "[8.1]") {
  check_jacobian<CornerFixture>();
}

TEST_CASE("8.1 the row of a ball is the slope of its gap at every pose", "[8.1]") {
  check_jacobian<BallOnTopFixture>();
}

TEST_CASE("8.1 the rate of a row is the corner's velocity relative to body 1",
          "[8.1]") {
  check_jacobian<CornerSlides>();
  check_jacobian<BallSlides>();
}

TEST_CASE("8.1 gap and rows of a corner are right at any size", "[8.1]") {
  if (!is_float)
    check_drawn(gap_table().subject, [](Draw& d) { return drawn_corner(d, false); });
  check_drawn(CornerFixture::J, [](Draw& d) { return drawn_corner(d, true); });
}

// ---- 8.2 the tangents ---------------------------------------------------------------------------

TEST_CASE("8.2 the first direction of friction is that of the sliding", "[8.2]") {
  const CaseTable<TangentCase> table = tangent_table();
  check_vectors(table, {"by hand", y, vec3(3, real(-2.49), 0)}, flat({x, -z}), rounding);
  check_vectors(table);
}

TEST_CASE("8.2 at rest there are two directions in the ground, too",
          "[8.2]") {
  const double loose = is_float ? 5e-3 : 1e-9;
  check_rest_is_finite();
  // is there an n for which t1 at rest lies in the ground? Then the stand-in itself is right
  const auto level = [=](const TangentCase& c) {
    const vec3 t1 = tangents(c.n, c.sliding)[0];
    return std::abs(double(dot(t1, c.n))) <= loose * double(length(t1));
  };
  const auto cases = rest_cases();
  const bool ever = std::any_of(cases.begin(), cases.end(), [=](const TangentCase& c) {
    return c.words == "at rest, tilted" && level(c);
  });
  for (const TangentCase& c : cases) {
    const auto [t1, t2] = tangents(c.n, c.sliding);
    const std::string given = tangent_given(c);
    Subject about = rest_subject;
    about.given = given.c_str();
    const auto same = [&](const std::string& entry, double yours, double right,
                          const std::string& words) {
      expect(about, entry + " (" + c.words + ")", yours, right, loose, {{yours, words}});
    };
    const double size = length(t1);
    same("length of t1", size, 1,
         size < loose ? "#zero-at-rest a zero vector: friction needs two directions at rest, too. "
                        "Begin with any vector that is not parallel to n"
                      : "#not-unit-vector-rest the substitute for the sliding is not normalised");
    same("t1.n", dot(t1, c.n), 0,
         ever && length(c.sliding) == 0
             ? stand_in_along_n
             : "#not-ground-rest t1 does not lie in the ground: subtract the part along n from the "
               "substitute for the sliding, too. The remainder of a vertical fall is rounding: do "
               "not normalise it");
    expect(about, "t2 (" + c.words + ")", t2, cross(c.n, t1), loose,
           {{cross(t1, c.n), "t2 = t1 x n: it is n x t1"},
            {t2, "t2 = n x t1 at rest, too"}});
  }
}

TEST_CASE("8.2 a tenth of a millimetre per second is slow enough and hardly more is not",
          "[8.2]") {
  check_drawn(tangent_table().subject, drawn_tangents, is_float ? 1e-3 : 1e-7);
}

// ---- 8.2 the impulse ----------------------------------------------------------------------------

TEST_CASE("8.2 the box of the text goes on sliding and friction is at its bound", "[8.2]") {
  const CaseTable<FrictionCase> table = friction_table();
  table.check({"by hand", 2.88, 11.0 / 60, 0.5, 1.2, 0}, {-0.6, -0.6});
}

TEST_CASE("8.2 the sum of friction stays within mu times the normal impulse", "[8.2]") {
  friction_table().check();
}

TEST_CASE("8.2 friction is bounded in all units, whatever it gave before", "[8.2]") {
  check_drawn({"8.2", "the impulse of friction", 2}, drawn_friction, is_float ? 1e-3 : 1e-9, 300);
}

// ---- 8.3 the corners and their loop -------------------------------------------------------------

TEST_CASE("8.3 the text's corner gets rows, and one of four that is highest does not", "[8.3]") {
  live_table().check({"by hand", {real(0.1)}, {real(-2.49)}, real(0.05)},
                     {1, 0, 0, 0, 0, 0, 0, 0, 0});
  live_table().check({"by hand, five are low", {0, real(-0.01), real(-0.02), real(-0.03),
                                               real(-0.04)}, {0, -1, 0, 2, 0}, real(0.01)},
                     {0, 1, 1, 1, 1, 0, 0, 0, 0});
}

TEST_CASE("8.3 at most four corners get rows: those that will be lowest", "[8.3]") {
  live_table().check();
  check_drawn({"8.3", "the corners that get rows"}, drawn_live);
}

TEST_CASE("8.3 the first iteration of the text's corner", "[8.3]") {
  check_numbers(contact_table(), paper_contact(paper_corner, paper),
                {0, 0, 0, 0, 0, 0, 3, -2.39, 0, -0.3, 0, -0.24, 0, 0, 1.2, 0, 0, 0, 0, 0, 0},
                "by hand ");
}

TEST_CASE("8.3 an iteration solves friction, friction and the normal row of each corner", "[8.3]") {
  check_numbers(contact_table());
  check_drawn({"8.3", "an iteration over the corners", 2}, drawn_contact);
}

// ---- 8.4 the rebound ----------------------------------------------------------------------------

TEST_CASE("8.4 the text's corner hits the ground with 6.3 m/s", "[8.4]") {
  check_numbers(speed_table(), {"pencil and paper", 0.0625, -6.45, -0.5, 0.05}, {6.3}, "by hand ");
  check_numbers(speed_table());
  check_drawn({"8.4", "the speed of an impact"}, drawn_impact_speed);
}

TEST_CASE("8.4 a ball leaves the ground, with as much as its bound allows", "[8.4]") {
  Numbers right(21, 0);
  right[7] = 3.4, right[14] = 19.7;
  check_numbers(rebound_table(), paper_rebound(0.6), right, "by hand ");
  right[7] = 2.58, right[14] = 18.06;
  check_numbers(rebound_table(), paper_rebound(0.4), right, "by hand ");
}

TEST_CASE("8.4 corners rebound together, and those without a rebound only push", "[8.4]") {
  check_numbers(rebound_table());
  check_drawn({"8.4", "the solve of a rebound", 2}, drawn_rebound);
}
