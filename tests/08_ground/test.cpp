// The tests of chapter 8's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include "tests/checker/catch.h"
#include "tests/checker/named.h"
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

bool differ(double a, double b, double tolerance) { return !(std::abs(a - b) <= tolerance); }

}  // namespace

// ---- 8.1 the gap -------------------------------------------------------------------------------

namespace {

// Whatever is wrong with C, the table's mistake explains it.
void expect_gap(const GapCase& c, const std::string& words, double right) {
  const CaseTable<GapCase> table = gap_table();
  const double yours = table.yours(c)[0];
  expect(table.subject, "C, " + c.words + words, yours, right, table.tolerance,
         differ(yours, right, table.tolerance) ? table.explain(yours) : std::vector<Suspect>{});
}

}  // namespace

TEST_CASE("8.1 the gap of the text's corner is ten centimetres", "[8.1]") {
  gap_table().check({"by hand", paper_corner, paper}, {0.1});
}

TEST_CASE("8.1 the gap of a corner is measured from the top along its own upright", "[8.1]") {
  gap_table().check();
}

TEST_CASE("8.1 a corner on the ground stays there while its body slides and turns about it",
          "[8.1]") {
  for (const GapCase& c : gap_cases())
    if (!c.words.ends_with(CornerFixture::broken.name)) expect_gap(c, "", 0);
}

TEST_CASE("8.1 a displacement along n changes the gap by the same length",
          "[8.1]") {
  for (GapCase c : gap_cases()) {
    const double before = gap(c.corner, c.pair.body1, c.pair.body2);
    const vec3 place = c.pair.body2.x, n = to_world(c.pair.body1, y);
    for (const double way : {0.1, -0.1, 2.0, -2.0}) {
      c.pair.body2.x = place + real(way) * n;
      expect_gap(c, ", lifted " + short_number(way), before + way);
    }
  }
}

TEST_CASE("8.1 a ball has the same gap however it is turned", "[8.1]") {
  Random random(811);
  for (int draw = 0; draw < 8; ++draw) {
    GapCase c{"ball", {vec3(0), real(0.3), real(0.5)}, uneven_pair()};
    move_together(c.pair, random);
    const double before = gap(c.corner, c.pair.body1, c.pair.body2);
    c.pair.body2.q = random.turn();
    expect_gap(c, " turned about its centre", before);
  }
}

// ---- 8.1 the rows -------------------------------------------------------------------------------

namespace {

const Subject rows_subject{"8.1", "the rates of the rows of a corner", 2};

// J V, how fast the corner moves along the direction of the row.
real rate(const Row& J, const Body& a, const Body& b) {
  return dot(J.v1, a.v) + dot(J.w1, a.w) + dot(J.v2, b.v) + dot(J.w2, b.w);
}
// A number of the rows: where it is wrong, the checker explains the rows themselves.
void expect_row(const std::string& entry, real yours, double right) {
  const double tolerance = 100 * rounding;
  if (differ(double(yours), right, tolerance)) explain_rows();
  expect(rows_subject, entry, double(yours), right, tolerance);
}
// Calls look(name of the row, row, pair) for each row of corners and balls at every pose.
template <class Look>
void for_each_row(const Look& look) {
  const auto each = [&](const std::string& what) {
    return [&, what](int pose, const Slides3& part, const Pair& pair) {
      const Jacobian<3> J = part.jacobian(pair.body1, pair.body2);
      for (int i = 0; i < 3; ++i)
        look("along " + std::string(CornerSlides::rows[std::size_t(i)]) + ", " + what +
                 corner_pose(pose),
             J[i], part, pair);
    };
  };
  for_each_pose<CornerSlides>(each("corner, "));
  for_each_pose<BallSlides>(each("ball, "));
}

}  // namespace

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

TEST_CASE("8.1 a corner neither slides nor leaves where both bodies move as one", "[8.1]") {
  Random random(812);
  for_each_row([&](const std::string& name, const Row& J, const Slides3&, const Pair& pair) {
    Body a = pair.body1, b = pair.body2;
    a.v = random.vector(2);
    b.w = a.w = random.vector(2);
    b.v = a.v + cross(a.w, b.x - a.x);
    expect_row("J V " + name, rate(J, a, b), 0);
  });
}

TEST_CASE("8.1 a ball that rolls does not slide", "[8.1]") {
  Random random(813);
  for (int draw = 0; draw < 8; ++draw) {
    const quat tilt = random.turn();
    const Corner part{vec3(0), real(0.3), real(0.5)};
    const vec3 n = tilt * y, t1 = tilt * x, t2 = cross(n, t1);
    const Body ground = static_body(random.vector(2), tilt);
    Body rolling = body_with(2, vec3(real(0.1)),
                             ground.x + (part.height + part.radius) * n + tilt * vec3(3, 0, -2),
                             random.turn());
    rolling.w = random.vector(3);
    rolling.v = cross(rolling.w, part.radius * n);
    for (const vec3& t : {t1, t2, n})
      expect_row("J V of a ball that rolls", rate(part.along(t, ground, rolling), ground,
                                                        rolling), 0);
  }
}

TEST_CASE("8.1 a corner gives no linear or angular momentum to two bodies together", "[8.1]") {
  for_each_row([&](const std::string& name, const Row& J, const Slides3&, const Pair& pair) {
    const vec3 push = J.v1 + J.v2;
    const vec3 L = cross(pair.body1.x, J.v1) + J.w1 + cross(pair.body2.x, J.v2) + J.w2;
    for (int k = 0; k < 3; ++k) {
      expect_row(std::string("push.") + "xyz"[k] + " " + name, push[k], 0);
      expect_row(std::string("L.") + "xyz"[k] + " " + name, L[k], 0);
    }
  });
}

// ---- 8.2 the tangents ---------------------------------------------------------------------------

TEST_CASE("8.2 the first direction of friction is that of the sliding", "[8.2]") {
  const CaseTable<TangentCase> table = tangent_table();
  check_vectors(table, {"by hand", y, vec3(3, real(-2.49), 0)}, flat({x, -z}), rounding);
  check_vectors(table);
}

TEST_CASE("8.2 falling faster does not turn the directions of friction", "[8.2]") {
  const CaseTable<TangentCase> table = tangent_table();
  for (const TangentCase& c : table.cases) {
    if (length(c.sliding) < real(0.1)) continue;
    const TangentCase faster{c.words + ", faster", c.n, c.sliding - real(2) * c.n};
    check_vectors(table, faster, table.right(c), table.tolerance);
  }
}

TEST_CASE("8.2 ground and velocity turned as one turn the directions of friction with them",
          "[8.2]") {
  const CaseTable<TangentCase> table = tangent_table();
  Random random(821);
  for (const TangentCase& c : table.cases) {
    const quat q = random.turn();
    const std::array<vec3, 2> before = tangents(c.n, c.sliding);
    check_vectors(table, {c.words + ", turned", q * c.n, q * c.sliding},
                  flat({q * before[0], q * before[1]}), 10 * table.tolerance);
  }
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

// ---- 8.2 the impulse ----------------------------------------------------------------------------

TEST_CASE("8.2 the box of the text goes on sliding and friction is at its bound", "[8.2]") {
  const CaseTable<FrictionCase> table = friction_table();
  table.check({"by hand", 2.88, 11.0 / 60, 0.5, 1.2, 0}, {-0.6, -0.6});
}

TEST_CASE("8.2 the sum of friction stays within mu times the normal impulse", "[8.2]") {
  friction_table().check();
}

TEST_CASE("8.2 friction is bounded in all units, whatever it gave before", "[8.2]") {
  check_drawn({"8.2", "the impulse of friction", 2}, drawn_friction);
}

TEST_CASE("8.2 friction stops slow bodies and slows fast ones by its bound", "[8.2]") {
  const real mass = 4, mu = real(0.5), normal = real(1.2);
  for (const real v0 : {real(0.1), real(-0.1), real(0.15), real(3), real(-3), real(0)})
    for (const int iterations : {1, 2, 30}) {
      real v = v0, sum = 0;
      for (int n = 0; n < iterations; ++n)
        v += friction_impulse(v, 1 / mass, mu, normal, sum) / mass;
      const real most = mu * normal / mass;
      expect_friction("speed after iterations: " + std::to_string(iterations), double(v),
                      double(v0 - std::clamp(v0, -most, most)),
                      "Case: 4 kg at " + short_number(double(v0)) +
                          " m/s, K 0.25 1/kg, mu 0.5, normal 1.2 N s, sum 0 N s at first.");
    }
}

TEST_CASE("8.2 friction never adds energy", "[8.2]") {
  for (FrictionCase c : friction_table().cases) {
    c.sum = 0;
    real sum = 0;
    const double change = friction_impulse(real(c.rate), real(c.K), real(c.mu), real(c.normal),
                                           sum);
    const double energy = change * (c.rate + c.K * change / 2);
    expect_friction("energy won", std::max(energy, 0.0), 0, friction_given(c));
  }
}

TEST_CASE("8.2 the sum of friction follows the normal impulse inwards", "[8.2]") {
  // the iterations take back what the normal row gave too much; nothing slides any more
  real sum = 0, given = 0;
  for (const real normal : {real(2), real(1.2), real(0.7), real(0.7), real(0)}) {
    const FrictionCase c{"", normal == 2 ? 3.0 : 0.0, 0.25, 0.5, double(normal), double(sum)};
    given += friction_impulse(real(c.rate), real(c.K), real(c.mu), normal, sum);
    expect_friction("sum", double(sum), -0.5 * double(normal), friction_given(c));
    expect_friction("given in all iterations", double(given), -0.5 * double(normal),
                    friction_given(c));
  }
}

TEST_CASE("8.2 friction in a mirror is the mirror image of friction", "[8.2]") {
  for (const FrictionCase& c : friction_table().cases) {
    real sum = real(c.sum), mirrored = -sum;
    const double one = friction_impulse(real(c.rate), real(c.K), real(c.mu), real(c.normal), sum);
    const double other =
        friction_impulse(real(-c.rate), real(c.K), real(c.mu), real(c.normal), mirrored);
    expect_friction("change in the mirror", other, -one, friction_given(c));
    expect_friction("sum in the mirror", double(mirrored), -double(sum), friction_given(c));
  }
}

// ---- what the tests know of mistakes ------------------------------------------------------------

TEST_CASE("each usual mistake of chapter 8 is called by its name") {
  are_sound(gap_table(), tangent_table(), friction_table());
}
