// What is true of the parts of hinge, slider and weld, alone and composed, at every kind of pose:
// rank, invariance, momentum, and numbers that stay numbers where the geometry degenerates.
#include "tests/checker/catch.h"
#include "tests/checker/joint_fixtures.h"
#include "tests/oracle/rigs.h"

using namespace joints;
using namespace joints::testing;

namespace {

// A joint with its limit as the last row, as a whole joint has it.
struct LimitedHingeFixture : HingeFixture {
  using Part = Composite<Composite<Point, Axis>, Limit<HingeAngle>>;
  static constexpr Subject J{"", "a hinge and its limit"};
  static Part make(const Pair& pair) {
    return {HingeFixture::make(pair), {HingeAngleFixture::make(pair), real(0.1), -1}};
  }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    HingeFixture::move_freely(part.first, pair, random);
  }
};
struct LimitedSliderFixture : SliderFixture {
  using Part = Composite<Composite<Line, RotationLock>, Limit<Slide>>;
  static constexpr Subject J{"", "a slider and its limit"};
  static Part make(const Pair& pair) {
    return {SliderFixture::make(pair), {SlideFixture::make(pair), real(0.1), 1}};
  }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    SliderFixture::move_freely(part.first, pair, random);
  }
};
// The same broken: what holds of any J holds there too.
template <class Fixture>
struct Broken : Fixture {
  static constexpr bool exact_when_broken = true;
};

template <class Fixture, class Look>
void at_every_pose(Look look) {
  INFO("part: " << Fixture::J.words);
  for_each_pose<Broken<Fixture>>([&](int pose, const auto& part, const Pair& pair) {
    INFO("pose: " << pose_names[std::size_t(pose)]);
    look(part, pair);
  });
}
template <class Look>
void for_every_joint(Look look) {
  at_every_pose<HingeFixture>(look);
  at_every_pose<LimitedHingeFixture>(look);
  at_every_pose<SliderFixture>(look);
  at_every_pose<LimitedSliderFixture>(look);
  at_every_pose<WeldFixture>(look);
}
template <class Look>
void for_every_part(Look look) {
  at_every_pose<AxisFixture>(look);
  at_every_pose<HingeAngleFixture>(look);
  at_every_pose<LineFixture>(look);
  at_every_pose<RotationLockFixture>(look);
  at_every_pose<SlideFixture>(look);
  for_every_joint(look);
}

// A part's numbers as matrices.
struct Numeric {
  Dense J, K;
  Column C;
  template <class Part>
  Numeric(const Part& part, const Body& a, const Body& b) {
    constexpr int N = Part::rows;
    J = {N, 12, flat(to_jacobian(part.jacobian(a, b)))};
    K = {N, N, flat(to_matrix(part.K(a, b)))};
    const Vector<N> error = to_vector(part.error(a, b));
    C = Column(N);
    for (int i = 0; i < N; ++i) C[i] = double(error[std::size_t(i)]);
  }
  bool all_finite() const { return J.finite() && K.finite() && C.finite(); }
};

long rank(const Dense& J) {
  return rank_of(J, tolerance(1e-10, 1e-4));
}

}  // namespace

TEST_CASE("the rank of J is the number of degrees of freedom that a joint removes") {
  for_every_joint([](const auto& part, const Pair& pair) {
    const long rows = std::decay_t<decltype(part)>::rows;
    CHECK(rank(Numeric(part, pair.body1, pair.body2).J) == rows);
  });
  CHECK(Composite<Point, Axis>::rows == 5);
  CHECK(Composite<Line, RotationLock>::rows == 5);
  CHECK(Weld::rows == 6);
  CHECK(LimitedHingeFixture::Part::rows == 6);
}

TEST_CASE("I2 K of a whole joint is J M^-1 J^T and positive while one body can move") {
  for_every_part([](const auto& part, const Pair& pair) {
    const Body wall = static_body(pair.body1.x, pair.body1.q);
    for (const Body& one : {pair.body1, wall}) {
      const Numeric at(part, one, pair.body2);
      const Dense K = at.J * inverse_masses({one, pair.body2}) * at.J.transpose();
      CHECK((at.K - K).largest() < tolerance(1e-12, 1e-5) * K.largest());
      CHECK(symmetric_eigenvalues(at.K)[0] > 0);
    }
    const Body rock = static_body(pair.body2.x, pair.body2.q);
    CHECK(Numeric(part, wall, rock).K.largest() == 0);
  });
}

TEST_CASE("I7 only the gap of a point lets a joint turn a free pair and nothing lets it push one") {
  for_every_part([](const auto& part, const Pair& pair) {
    const Numeric at(part, pair.body1, pair.body2);
    constexpr bool has_point = requires { part.first.anchor1_local; part.second.a1_local; } ||
                               requires { part.first.second.a1_local; } ||
                               std::is_same_v<std::decay_t<decltype(part)>, Weld>;
    const dvec3 x1 = dvec3(pair.body1.x), x2 = dvec3(pair.body2.x);
    for (long i = 0; i < at.J.rows(); ++i) {
      const Column row = at.J.rows_from(i, 1).transpose();
      const dvec3 v1 = three(row), w1 = three(row, 3), v2 = three(row, 6), w2 = three(row, 9);
      CHECK(v1 == -v2);
      dvec3 expected(0);
      if (has_point && i < 3) expected = cross(three(at.C), dmat3(1)[int(i)]);
      const dvec3 moment = cross(x1, v1) + w1 + cross(x2, v2) + w2;
      CHECK(length(moment - expected) < tolerance(1e-14, 1e-5));
    }
  });
}

TEST_CASE("I8 a pair that is turned and moved as one keeps the errors and the K of its joint") {
  for_every_part([](const auto& part, const Pair& pair) {
    Random random(61);
    Pair other = pair;
    move_together(other, random);
    const Numeric here(part, pair.body1, pair.body2), there(part, other.body1, other.body2);
    const double near = tolerance(1e-11, 1e-4);
    CHECK(std::abs(there.C.norm() - here.C.norm()) < near);
    CHECK((symmetric_eigenvalues(there.K) - symmetric_eigenvalues(here.K)).largest() <
          near * here.K.largest());
  });
  // errors that are measured in a body's own directions keep every single number
  const auto same = [](const auto& part, const Pair& pair) {
    Random random(62);
    Pair other = pair;
    move_together(other, random);
    const Numeric before(part, pair.body1, pair.body2), after(part, other.body1, other.body2);
    CHECK((after.C - before.C).largest() < tolerance(1e-12, 1e-5));
  };
  at_every_pose<AxisFixture>(same);
  at_every_pose<HingeAngleFixture>(same);
  at_every_pose<LineFixture>(same);
  at_every_pose<SlideFixture>(same);
}

TEST_CASE("I9 the angle is the twist to within rounding at any misalignment below 1 rad") {
  Random random(63);
  for (int draw = 0; draw < 200; ++draw) {
    Pair pair = uneven_pair();
    const vec3 a1 = normalize(random.vector(1) + vec3(0, 0, real(0.2)));
    const HingeAngle part = angle_about(pair.body1, pair.body2, a1);
    const real twist = random.uniform(-3, 3);
    vec3 across = cross(a1, random.vector(1));
    across = random.uniform(0, 1) * normalize(across);
    // first the twist about the axis, then a swing across it
    pair.body2.q = normalize(rotation(across) * rotation(twist * a1) * pair.body2.q);
    CHECK(double(part.twist(pair.body1, pair.body2)) ==
          Approx(double(twist)).margin(tolerance(1e-12, 5e-6)));
  }
}

TEST_CASE("I10 the two numbers of the axis are the sine of the misalignment up to 60 degrees") {
  Random random(64);
  for (int draw = 0; draw < 200; ++draw) {
    Pair pair = uneven_pair();
    const vec3 axis = normalize(random.vector(1) + vec3(0, 0, real(0.2)));
    const Axis part = axis_along(pair.body1, pair.body2, axis);
    const real angle = random.uniform(0, 3);
    pair.body2.q = normalize(rotation(angle * normalize(cross(axis, random.vector(1)))) *
                             pair.body2.q);
    const Vector<2> C = part.error(pair.body1, pair.body2);
    const double size = std::hypot(double(C[0]), double(C[1]));
    const bool far = double(angle) > std::numbers::pi / 3;  // from there on the turn itself
    CHECK(part.far_off(pair.body1, pair.body2) == far);
    CHECK(size == Approx(far ? double(angle) : std::sin(double(angle)))
                      .margin(tolerance(1e-12, 2e-6)));
  }
}

TEST_CASE("I28 the sign of a quaternion changes no number of hinge or slider or weld") {
  for_every_part([](const auto& part, const Pair& pair) {
    const Numeric plain(part, pair.body1, pair.body2);
    for (int which = 1; which <= 3; ++which) {
      Body a = pair.body1, b = pair.body2;
      if (which & 1) a.q = -a.q;
      if (which & 2) b.q = -b.q;
      const Numeric other(part, a, b);
      CHECK((other.C == plain.C));  // not a bit
      CHECK((other.J == plain.J));
      CHECK((other.K == plain.K));
    }
  });
}

TEST_CASE("I27 axes at right angles or opposite and locks half a turn off give finite numbers") {
  const auto look = [](auto part, const Pair& pair) {
    std::vector<quat> turns;
    const real r = std::sqrt(real(0.5));
    for (const vec3& axis : {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)})
      for (real sign : {real(1), real(-1)}) {
        const vec3 v = sign * axis;
        turns.push_back(quat(0, v.x, v.y, v.z));           // half a turn, exactly
        turns.push_back(quat(r, r * v.x, r * v.y, r * v.z));  // a quarter
      }
    for (const quat& turn : turns) {
      Pair bent = pair;
      bent.body2.q = turn * bent.body2.q;
      CHECK(Numeric(part, bent.body1, bent.body2).all_finite());
      bent.body2.q = turn * bent.body1.q;  // aligned with body 1's own axes, whatever the start
      CHECK(Numeric(part, bent.body1, bent.body2).all_finite());
      bent.body2.x = bent.body1.x;
      CHECK(Numeric(part, bent.body1, bent.body2).all_finite());
    }
  };
  for_every_part(look);
  // and with the axis along that of the turns, so that a1 = -a2 and a1.a2 = 0 exactly
  const Body wall = static_body(vec3(0)), body = box(2, vec3(1, 2, 3), vec3(0));
  for (const vec3& axis : {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)}) {
    look(axis_along(wall, body, axis), {wall, body});
    look(angle_about(wall, body, axis), {wall, body});
    look(lock_of(wall, body), {wall, body});
    look(Composite<Point, Axis>{{}, axis_along(wall, body, axis)}, {wall, body});
    look(Weld{{}, lock_of(wall, body)}, {wall, body});
  }
}
