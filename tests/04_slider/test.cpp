// The tests of chapter 4's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include "tests/04_slider/drawn_cases.h"
#include "tests/04_slider/line_cases.h"
#include "tests/04_slider/lock_cases.h"
#include "tests/checker/catch.h"

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

TEST_CASE("4.1 a point is as far beside its line as it is, near or far", "[4.1]") {
  check_drawn({"4.1", "C of a line"}, drawn_line, is_float ? 1e-3 : 1e-9, 300);
}

TEST_CASE("4.1 the rows of a line have their levers at any distance", "[4.1]") {
  check_drawn({"4.1", "the rows J of a line", 2}, drawn_line_rows);
}

// ---- 4.2 ----------------------------------------------------------------------------------------

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

TEST_CASE("4.2 the rate of a lock is the angular velocity of body 2 relative to body 1", "[4.2]") {
  Jacobian<3> by_hand;
  for (int k = 0; k < 3; ++k) by_hand[k].w1[k] = -1, by_hand[k].w2[k] = 1;
  check_jacobian<Locks>({RotationLock{quarter_z}}, {paper1, static_body(vec3(0), quarter_z)},
                        by_hand);
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
    const quat extra = random.turn(draw < 4 ? 1 : 3);
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

TEST_CASE("4.3 the row of the displacement has its levers at any distance", "[4.3]") {
  check_drawn(SlideFixture::J, drawn_slide_row);
}

TEST_CASE("4.3 a displacement is right at any distance", "[4.3]") {
  check_drawn({"4.3", "the displacement"}, drawn_slide, is_float ? 1e-3 : 1e-9, 300);
}
