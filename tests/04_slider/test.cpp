// The tests of chapter 4's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include <algorithm>

#include "tests/checker/catch.h"
#include "tests/04_slider/slider_twins.h"

using namespace joints;
using namespace joints::testing;

namespace {

const real half = std::sqrt(real(0.5));  // cos 45 degrees
const quat unturned_q(1, 0, 0, 0), quarter_z(half, 0, 0, half);

// The poses for pencil and paper in the chapter's text.
const Body paper1 = static_body(vec3(0));
const vec3 moments(real(0.4), real(0.5), real(0.4));
const Body paper2 = body_with(2, moments, vec3(2, real(1.5), 0), quarter_z);
const Line paper_line{vec3(0, 1, 0), vec3(0, real(0.5), real(0.5)), vec3(0, 1, 0), vec3(0, 0, 1)};
const Slide paper_slide{vec3(0, 1, 0), vec3(0, real(0.5), real(0.5)), vec3(1, 0, 0)};

const Subject line_C{"4.1", "the error C of a line"};
const Subject lock_C{"4.2", "the error C of a lock"};
const Subject way_C{"4.3", "the way along a line"};

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

// Both numbers of C; a suspect is one for both.
void expect_C(int pose, const Line& line, const Pair& pair) {
  const vec3 u = gap(line, pair.body1, pair.body2), d = pair.body2.x - pair.body1.x;
  const auto along = [&](const vec3& arrow, const quat& turn) -> Vector<2> {
    return {dot(arrow, turn * line.n1_local), dot(arrow, turn * line.n2_local)};
  };
  const quat &q1 = pair.body1.q, &q2 = pair.body2.q;
  const Vector<2> right = along(u, q1), yours = line.error(pair.body1, pair.body2);
  const std::pair<Vector<2>, const char*> mistakes[] = {
      {along(-u, q1), "the sign: u runs from the point of body 1 to that of body 2"},
      {along(u, unturned_q), "n is left in body space: turn it into the world with body 1"},
      {along(u, conjugate(q1)), "n is turned the wrong way round: to_world, not to_local"},
      {along(u, q2), "n is turned with body 2: the line rides on body 1"},
      {along(d, q1), "centres in place of anchors: u is p2 - p1"},
      {along(d, unturned_q), "centres in place of anchors, and n left in body space"},
      {{right[1], right[0]}, "n1 and n2 are exchanged"},
      {{right[0], right[0]}, "n1 twice: the second number belongs to n2"},
      {{right[0], 0}, "the second number is missing"}};
  for (int i = 0; i < 2; ++i) {
    std::vector<Suspect> suspects;
    for (const auto& [C, words] : mistakes)
      if (close({double(C[0]), double(C[1])}, {double(yours[0]), double(yours[1])}, 10 * rounding))
        suspects.push_back({double(C[i]), words});
    expect(line_C, at(row_names<LineFixture>()[i], pose), double(yours[i]), double(right[i]),
           10 * rounding, suspects);
  }
}

void expect_way(int pose, const Slide& slide, const Pair& pair) {
  const vec3 u = gap(slide, pair.body1, pair.body2), a = to_world(pair.body1, slide.a1_local);
  const vec3 d = pair.body2.x - pair.body1.x;
  const double right = double(dot(u, a));
  expect(way_C, at("way", pose), double(slide.error(pair.body1, pair.body2)), right, 10 * rounding,
         {{std::abs(right), "the way has a sign: it is negative behind the start"},
          {-right, "the sign: the way grows when body 2 moves along a"},
          {double(dot(d, a)), "centres in place of anchors: u is p2 - p1"},
          {double(dot(u, slide.a1_local)), "a is left in body space: turn it with body 1"},
          {double(dot(u, to_world(pair.body2, slide.a1_local))),
           "a is turned with body 2: the line rides on body 1"},
          {double(length(u)), "the length of u: only its part along a is the way"}});
}

}  // namespace

// ---- 4.1 ----------------------------------------------------------------------------------------

TEST_CASE("4.1 the error of a line is how far its point stands beside it", "[4.1]") {
  expect_C(pencil_and_paper, paper_line, {paper1, paper2});
  visit_poses<LineFixture>(expect_C);
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

TEST_CASE("4.1 the push on one body and the answer on the other act along one line", "[4.1]") {
  // that is what the lever r1 + u is for: both act at the point p2
  visit_poses<LineFixture>([](int pose, const Line& line, const Pair& pair) {
    const Jacobian<2> J = line.jacobian(pair.body1, pair.body2);
    const vec3 n[] = {to_world(pair.body1, line.n1_local), to_world(pair.body1, line.n2_local)};
    for (int i = 0; i < 2; ++i) check_momentum(LineFixture::J, pose, line, pair, J[i], n[i]);
  });
}

// ---- 4.2 ----------------------------------------------------------------------------------------

namespace {

vec3 vector_of(const quat& q) { return {q.x, q.y, q.z}; }

// C beside everything that is often taken for it.
void expect_lock(const std::string& entry, const RotationLock& lock, const Body& body1,
                 const Body& body2) {
  const quat q1 = body1.q, q2 = body2.q, start = lock.start;
  const quat back1 = conjugate(q1), back = conjugate(start), e = q2 * back * back1;
  const vec3 v = short_way(e), C = real(2) * v;
  const real s = std::abs(e.w), sine = length(v);
  const vec3 phi = sine > 0 ? 2 * std::atan2(sine, s) / sine * v : vec3(0);
  const vec3 three_angles = glm::eulerAngles(q2) - glm::eulerAngles(q1);
  const char* const angles = "differences of angles about three axes: these are no rotation, and "
                             "their rates are not the spins. C is 2 v";
  const bool either = length(phi - three_angles) < 1e-3;  // only one axis: both are the same
  const char* const order = "the order of the product: q2, then start^-1, then q1^-1";
  std::vector<VectorSuspect> suspects{
      {-C, e.w < 0 ? "the sign rule is forgotten: where s < 0, take -q"
                   : "the sign: body 2 is turned too far, so q2 stands first and q1 is inverted; "
                     "and -q is taken where s < 0, not where s > 0"},
      {v, "the factor 2 is forgotten: v is only half the turn"},
      {vector_of(e), "the factor 2 and the sign rule are forgotten"},
      {phi, either ? "angles: C is 2 v, whose length is 2 sin(angle/2)"
                   : "the vector of the turn itself: C is 2 v, whose length is 2 sin(angle/2)"},
      {s * C, "the sine of the whole angle: it is zero again at a half turn"},
      {C / s, "the tangent of half the angle: it has no bound at a half turn"},
      {real(2) * vec3(e.w, e.x, e.y), "the numbers w, x, y: the vector of q is (q.x, q.y, q.z)"},
      {three_angles, angles},
      {glm::eulerAngles(back1 * q2) - glm::eulerAngles(start), angles},
      {glm::eulerAngles(q2 * back) - glm::eulerAngles(q1), angles},
      {glm::eulerAngles(e.w < 0 ? -e : e), angles}};
  const std::pair<quat, const char*> products[] = {
      {q2 * back1, "start is forgotten: the turn that the bodies began with is no error"},
      {back1 * q2, "start is forgotten, and the order is q2 q1^-1"},
      {q2 * start * back1, "start must be inverted"},
      {q2 * back1 * back, "start is on the wrong side of q1^-1: (q1 start)^-1 = start^-1 q1^-1"},
      {back * q2 * back1, order}, {q2 * start * q1, order}, {q2 * back * q1, order},
      {back1 * back * q2, order}, {back1 * start * q2, order},
      {back1 * q2 * back, "in the axes of body 1: C is in the world, q2 start^-1 q1^-1"},
      {back * back1 * q2, "in the axes of body 2: C is in the world, q2 start^-1 q1^-1"},
      {back1 * q2 * start, "start must be inverted, and the order is q2 start^-1 q1^-1"}};
  for (const auto& [q, words] : products)
    for (const vec3& turn : {short_way(q), vector_of(q), -short_way(q)}) {
      suspects.push_back({real(2) * turn, words});
      suspects.push_back({turn, std::string(words) + "; the factor 2 is forgotten as well"});
    }
  suspects.push_back({real(2) * vector_of(q2 - q1), "a difference of quaternions is no turn"});
  suspects.push_back({vec3(0), "C is zero, though body 2 is turned too far"});
  expect(lock_C, entry, lock.error(body1, body2), C, 10 * rounding, suspects);
}

Body turned_by(const quat& q) { return static_body(vec3(0), q); }
Body opposite(Body body) {
  body.q = -body.q;
  return body;
}

}  // namespace

TEST_CASE("4.2 a quarter turn too much is an error of twice the sine of its half", "[4.2]") {
  const std::string entry = at("C", pencil_and_paper);
  expect_lock(entry, RotationLock{unturned_q}, paper1, turned_by(quarter_z));
  expect_lock(entry + ", -q2", RotationLock{unturned_q}, paper1, opposite(turned_by(quarter_z)));
  expect_lock(entry + ", start = q2", RotationLock{quarter_z}, paper1, turned_by(quarter_z));
}

TEST_CASE("4.2 what the bodies began with is no error wherever they are turned", "[4.2]") {
  Random random(42);
  for (int draw = 0; draw < 8; ++draw) {
    const Body body1 = turned_by(random.turn()), body2 = turned_by(random.turn());
    const RotationLock lock{random.turn()};
    expect_lock("C", lock, body1, body2);
    expect_lock("C of bodies that are held", lock, body1, turned_by(body1.q * lock.start));
  }
}

TEST_CASE("4.2 q and -q are the same orientation and give the same error bit for bit", "[4.2]") {
  Random random(43);
  const char* const rule = "the sign rule is forgotten: where s < 0, take -q";
  for (int draw = 0; draw < 8; ++draw) {
    const Body body1 = turned_by(random.turn()), body2 = turned_by(random.turn());
    const RotationLock lock{random.turn()}, other{-lock.start};
    const vec3 C = lock.error(body1, body2);
    expect(lock_C, "C from -q1", lock.error(opposite(body1), body2), C, 0, {{-C, rule}});
    expect(lock_C, "C from -q2", lock.error(body1, opposite(body2)), C, 0, {{-C, rule}});
    expect(lock_C, "C from -start", other.error(body1, body2), C, 0, {{-C, rule}});
  }
}

TEST_CASE("4.2 where the pair turns as one its error turns with it", "[4.2]") {
  Random random(44);
  for (int draw = 0; draw < 8; ++draw) {
    const Body body1 = turned_by(random.turn()), body2 = turned_by(random.turn());
    const RotationLock lock{random.turn()};
    const quat turn = random.turn();
    const vec3 C = lock.error(body1, body2);
    const vec3 yours = lock.error(turned_by(turn * body1.q), turned_by(turn * body2.q));
    expect(lock_C, "C of the turned pair", yours, turn * C, 10 * rounding,
           {{C, "it is in the axes of a body: C is in the world, q2 start^-1 q1^-1"},
            {-(turn * C), "the sign rule is forgotten: where s < 0, take -q"},
            {yours, "it is not made of the turn q2 start^-1 q1^-1 alone"}});
  }
}

TEST_CASE("4.2 at a half turn the error is largest and finite", "[4.2]") {
  Random random(45);
  for (int draw = 0; draw < 8; ++draw) {
    const quat q1 = draw == 0 ? unturned_q : random.turn();
    const vec3 axis = draw == 0 ? vec3(0, 0, 1) : normalize(random.vector(1));
    const Body body1 = turned_by(q1), body2 = turned_by(quat(0, axis.x, axis.y, axis.z) * q1);
    expect(lock_C, "|C| at a half turn", double(length(RotationLock{}.error(body1, body2))), 2,
           10 * rounding,
           {{1, "the factor 2 is forgotten"},
            {0, "the sine of the whole angle: it is zero again at a half turn"},
            {3.14159265358979, "an angle: C is 2 v, whose length is 2 sin(angle/2)"}});
    double sum = 0;
    for (double entry : flat(RotationLock{}.jacobian(body1, body2))) sum += entry;
    expect(RotationLockFixture::J, "is J a number (1 yes, 0 no)", std::isfinite(sum), 1, 0);
  }
}

TEST_CASE("4.2 a lock feels how much faster body 2 spins than body 1", "[4.2]") {
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
    suspect("the sign of skew(v)", rows(-(s * E - across), s * E + across));
    suspect("skew(v) is missing: s alone is neither Eq. 4-8 nor exact", rows(-s * E, s * E));
    suspect("the sign rule belongs to s and v of J, too", rows(-(e.w * E + skew(vector_of(e))),
                                                               e.w * E - skew(vector_of(e))));
    samples.push_back(sample);
  }
  check(RotationLockFixture::J,
        jacobian_report(row_names<RotationLockFixture>(), samples, difference_tolerance));
}

// ---- 4.3 ----------------------------------------------------------------------------------------

TEST_CASE("4.3 the way is the part of the gap along the line", "[4.3]") {
  expect_way(pencil_and_paper, paper_slide, {paper1, paper2});
  visit_poses<SlideFixture>(expect_way);
}

TEST_CASE("4.3 the row of a motor has levers", "[4.3]") {
  check_jacobian<Slides>({paper_slide}, {paper1, paper2},
                     to_jacobian(Row{vec3(-1, 0, 0), vec3(0, real(-0.5), real(1.5)), vec3(1, 0, 0),
                                     vec3(0, real(0.5), 0)}));
}

TEST_CASE("4.3 the row of the way is its slope at every pose", "[4.3]") {
  check_jacobian<Slides>();
}

TEST_CASE("4.3 a motor gives the pair no angular momentum", "[4.3]") {
  visit_poses<SlideFixture>([](int pose, const Slide& slide, const Pair& pair) {
    check_momentum(SlideFixture::J, pose, slide, pair, slide.jacobian(pair.body1, pair.body2),
                   to_world(pair.body1, slide.a1_local));
  });
}
