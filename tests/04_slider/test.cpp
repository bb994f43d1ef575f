// The tests of chapter 4's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include "tests/04_slider/drawn_cases.h"
#include "tests/04_slider/line_cases.h"
#include "tests/04_slider/lock_cases.h"
#include "tests/checker/catch.h"
#include "tests/checker/named.h"

using namespace joints;
using namespace joints::testing;

namespace {

const char* const told_exact_same_sign =
    "#exact-same-sign the sign of skew(v) in one block: w1 holds -(s E + skew(v)), w2 s E - "
    "skew(v)";

const real half = std::sqrt(real(0.5));  // cos 45 degrees
const quat unturned_q(1, 0, 0, 0), quarter_z(half, 0, 0, half);

// The poses for pencil and paper in the chapter's text.
const Body paper1 = static_body(vec3(0));
const vec3 moments(real(0.4), real(0.5), real(0.4));
const Body paper2 = body_with(2, moments, vec3(2, real(1.5), 0), quarter_z);
const Line paper_line{vec3(0, 1, 0), vec3(0, real(0.5), real(0.5)), vec3(0, 1, 0), vec3(0, 0, 1)};
const Slide paper_slide{vec3(0, 1, 0), vec3(0, real(0.5), real(0.5)), vec3(1, 0, 0)};

// ---- comparing ----------------------------------------------------------------------------------

std::string at(const std::string& entry, int pose) { return entry + " (" + pose_names[pose] + ")"; }

// An impulse of 1 along the row of n must not give the pair angular momentum (about the origin).
template <class Part>
void check_momentum(const Subject& subject, int pose, const Part& part, const Pair& pair,
                    const Row& J, const vec3& n) {
  const vec3 r1 = to_world(pair.body1, part.anchor1_local);
  const vec3 r2 = to_world(pair.body2, part.anchor2_local);
  const vec3 u = gap(part, pair.body1, pair.body2);
  const char* const lines = ": push and answer act along two lines, and that turns the pair";
  expect(subject, at("angular momentum", pose),
         cross(pair.body1.x, J.v1) + J.w1 + cross(pair.body2.x, J.v2) + J.w2, vec3(0),
         10 * rounding,
         {{cross(u, n), std::string("u belongs to the lever of body 1 and to no other") + lines},
          {cross(u + r1 - r2, n), std::string("levers are missing, or are points") + lines},
          {cross(u + r1, n), "the lever of body 1 is missing"},
          {-cross(r2, n), "the lever of body 2 is missing"}});
}

}  // namespace

// ---- 4.1 ----------------------------------------------------------------------------------------

TEST_CASE("4.1 the error of a line is the displacement of its point beside it", "[4.1]") {
  const CaseTable<PartCase<Line>> table = line_table();
  table.check({pose_names[pencil_and_paper], paper_line, {paper1, paper2}}, {0.5, 0.5});
  table.check();
}

TEST_CASE("4.1 the lever of body 1 reaches to the point of body 2", "[4.1]") {
  Jacobian<2> J;  // r1 + u = (1.5, 1.5, 0.5), r2 = (-0.5, 0, 0.5)
  J[0] = {vec3(0, -1, 0), vec3(real(0.5), 0, real(-1.5)), vec3(0, 1, 0),
          vec3(real(-0.5), 0, real(-0.5))};
  J[1] = {vec3(0, 0, -1), vec3(real(-1.5), real(1.5), 0), vec3(0, 0, 1), vec3(0, real(0.5), 0)};
  check_jacobian<Lines>({paper_line}, {paper1, paper2}, J);
}

TEST_CASE("4.1 the rows of a line are the slopes of its error at every pose", "[4.1]") {
  check_jacobian<Lines>();
}

TEST_CASE("4.1 the impulses on both bodies act along one line", "[4.1]") {
  // that is what the lever r1 + u is for: both act at the point p2
  for_each_pose<LineFixture>([](int pose, const Line& line, const Pair& pair) {
    const Jacobian<2> J = line.jacobian(pair.body1, pair.body2);
    const vec3 n[] = {to_world(pair.body1, line.n1_local), to_world(pair.body1, line.n2_local)};
    for (int i = 0; i < 2; ++i) check_momentum(LineFixture::J, pose, line, pair, J[i], n[i]);
  });
}

TEST_CASE("4.1 a point is as far beside its line as it is, near or far", "[4.1]") {
  check_drawn({"4.1", "C of a line"}, drawn_line, is_float ? 1e-3 : 1e-9, 300);
}

TEST_CASE("4.1 the rows of a line have their levers at any distance", "[4.1]") {
  check_drawn({"4.1", "the rows J of a line", 2}, drawn_line_rows);
}

// ---- 4.2 ----------------------------------------------------------------------------------------

namespace {

Body turned_by(const quat& q) { return static_body(vec3(0), q); }
Body opposite(Body body) {
  body.q = -body.q;
  return body;
}

}  // namespace

TEST_CASE("4.2 a quarter turn too much is an error of twice the sine of its half", "[4.2]") {
  const CaseTable<LockCase> table = lock_table();
  const std::string paper = pose_names[pencil_and_paper];
  const double sine = std::sqrt(2.0);
  table.check({paper, unturned_q, quarter_z, unturned_q}, {0, 0, sine});
  table.check({paper + ", -q2", unturned_q, -quarter_z, unturned_q}, {0, 0, sine});
  table.check({paper + ", start = q2", unturned_q, quarter_z, quarter_z}, {0, 0, 0});
}

TEST_CASE("4.2 the initial relative orientation is never an error", "[4.2]") {
  lock_table().check();
}

TEST_CASE("4.2 q and -q are the same orientation and give the same error bit for bit", "[4.2]") {
  const CaseTable<LockCase> table = lock_table();
  const char* const rule = "#sign-rule-w-alone the sign rule is forgotten: where s < 0, take -q";
  for (const LockCase& c : table.cases) {
    if (c.words != "turned") continue;
    const Body body1 = turned_by(c.q1), body2 = turned_by(c.q2);
    const RotationLock lock{c.start}, other{-c.start};
    const vec3 C = lock.error(body1, body2);
    const auto same = [&](const char* entry, const vec3& yours) {
      expect(table.subject, entry, yours, C, 0, {{-C, rule}});
    };
    same("C from -q1", lock.error(opposite(body1), body2));
    same("C from -q2", lock.error(body1, opposite(body2)));
    same("C from -start", other.error(body1, body2));
  }
}

TEST_CASE("4.2 if the pair rotates as one its error rotates with it", "[4.2]") {
  const CaseTable<LockCase> table = lock_table();
  Random random(44);
  for (const LockCase& c : table.cases) {
    const RotationLock lock{c.start};
    const quat turn = random.turn();
    const vec3 C = lock.error(turned_by(c.q1), turned_by(c.q2));
    const vec3 yours = lock.error(turned_by(turn * c.q1), turned_by(turn * c.q2));
    expect(table.subject, "C of the turned pair", yours, turn * C, 10 * rounding,
           table.explain(yours));
  }
}

TEST_CASE("4.2 at a half turn the error is largest and finite", "[4.2]") {
  const CaseTable<LockCase> table = lock_table();
  Random random(45);
  for (int draw = 0; draw < 8; ++draw) {
    const quat q1 = draw == 0 ? unturned_q : random.turn();
    const vec3 axis = draw == 0 ? vec3(0, 0, 1) : normalize(random.vector(1));
    const Body body1 = turned_by(q1), body2 = turned_by(quat(0, axis.x, axis.y, axis.z) * q1);
    const double size = double(length(RotationLock{}.error(body1, body2)));
    expect(table.subject, "|C| at a half turn", size, 2, 10 * rounding, table.explain(size));
    double sum = 0;
    for (double entry : flat(RotationLock{}.jacobian(body1, body2))) sum += entry;
    expect(RotationLockFixture::J, "is J a number (1 yes, 0 no)", std::isfinite(sum), 1, 0);
  }
}

TEST_CASE("4.2 the rate of a lock is the angular velocity of body 2 relative to body 1", "[4.2]") {
  check_jacobian<Locks>({RotationLock{quarter_z}}, {paper1, turned_by(quarter_z)},
                    jacobian_from_blocks(mat3(0), mat3(-1), mat3(0), mat3(1)));
}

TEST_CASE("4.2 the rows of a lock are the slopes of its error where it is zero", "[4.2]") {
  check_jacobian<Locks>();
}

TEST_CASE("4.2 away from zero the rows are those of Eq. 4-8 or the exact ones", "[4.2]") {
  Random random(46);
  std::vector<Sample> samples;
  for (int draw = 0; draw < 8; ++draw) {
    Pair pair = uneven_pair();
    move_together(pair, random);
    const RotationLock lock = lock_of(pair.body1, pair.body2);
    const quat extra = random.turn(1);
    pair.body2.q = draw % 2 ? extra * pair.body2.q : -(extra * pair.body2.q);
    const quat e = pair.body2.q * conjugate(lock.start) * conjugate(pair.body1.q);
    const real s = std::abs(e.w);
    const mat3 across = skew(short_way(e)), E(1);
    const auto rows = [](const mat3& one, const mat3& two) {
      return flat(jacobian_from_blocks(mat3(0), one, mat3(0), two));
    };
    const Numbers yours = flat(lock.jacobian(pair.body1, pair.body2));
    const Numbers plain = rows(-E, E), exact = rows(-(s * E + across), s * E - across);
    const bool is_plain = close(yours, plain, 10 * rounding);
    Sample sample{3, yours, is_plain ? plain : exact, {}};
    const auto suspect = [&](const char* words, const Numbers& wrong) {
      if (close(yours, wrong, 10 * rounding)) sample.mistakes.push_back(words);
    };
    suspect("#exact-rows-other-sign the sign of skew(v)", rows(-(s * E - across), s * E + across));
    suspect("#rows-s-alone skew(v) is missing: s alone is neither Eq. 4-8 nor exact",
            rows(-s * E, s * E));
    suspect(told_exact_same_sign,
            rows(-(s * E + across), s * E + across));
    suspect(told_exact_same_sign,
            rows(-(s * E - across), s * E - across));
    suspect("#exact-without-sign-rule the sign of the whole row where s < 0: the sign rule "
            "belongs to s and v of J, too",
            rows(-(e.w * E + skew(vector_of(e))), e.w * E - skew(vector_of(e))));
    samples.push_back(sample);
  }
  check(RotationLockFixture::J,
        jacobian_report(row_names<RotationLockFixture>(), samples, difference_tolerance));
}

TEST_CASE("4.2 the error of a lock is right near half a turn and near none", "[4.2]") {
  if (!is_float) check_drawn({"4.2", "C of a lock"}, drawn_lock, 1e-9, 400);
}

// ---- 4.3 ----------------------------------------------------------------------------------------

TEST_CASE("4.3 the displacement is the part of the gap along the line", "[4.3]") {
  const CaseTable<PartCase<Slide>> table = slide_table();
  table.check({pose_names[pencil_and_paper], paper_slide, {paper1, paper2}}, {1.5});
  table.check();
}

TEST_CASE("4.3 the row of a motor has levers", "[4.3]") {
  check_jacobian<Slides>({paper_slide}, {paper1, paper2},
                     to_jacobian(Row{vec3(-1, 0, 0), vec3(0, real(-0.5), real(1.5)), vec3(1, 0, 0),
                                     vec3(0, real(0.5), 0)}));
}

TEST_CASE("4.3 the row of the displacement is its slope at every pose", "[4.3]") {
  check_jacobian<Slides>();
}

TEST_CASE("4.3 a motor gives the pair no angular momentum", "[4.3]") {
  for_each_pose<SlideFixture>([](int pose, const Slide& slide, const Pair& pair) {
    check_momentum(SlideFixture::J, pose, slide, pair, slide.jacobian(pair.body1, pair.body2),
                   to_world(pair.body1, slide.a1_local));
  });
}

TEST_CASE("4.3 a displacement is right at any distance", "[4.3]") {
  check_drawn({"4.3", "the displacement"}, drawn_slide, is_float ? 1e-3 : 1e-9, 300);
}

// ---- what the tests know of mistakes ------------------------------------------------------------

TEST_CASE("each usual mistake of chapter 4 is called by its name") {
  are_sound(line_table(), lock_table(), slide_table());
}
