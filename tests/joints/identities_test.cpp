// What is true of every part, alone and composed, at every kind of pose: rates, rank, invariance,
// momentum, and numbers that stay numbers where the geometry degenerates.
#include "tests/checker/joint_fixtures.h"
#include "tests/oracle/test.h"

namespace {

struct CentreRopeFixture : CentreDistanceFixture {
  using Part = Rope<CentreDistance>;
  static constexpr Subject J{"", "the row J of a rope from centre to centre"};
  static Part make(const Pair& pair) { return {CentreDistanceFixture::make(pair)}; }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    CentreDistanceFixture::move_freely(part.rod, pair, random);
  }
};
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
// Rods, ropes and the ball joint.
template <class Look>
void for_every_push(Look look) {
  at_every_pose<CentreDistanceFixture>(look);
  at_every_pose<DistanceFixture>(look);
  at_every_pose<CentreRopeFixture>(look);
  at_every_pose<RopeFixture>(look);
  at_every_pose<PointFixture>(look);
}
template <class Look>
void for_every_joint(Look look) {
  at_every_pose<HingeFixture>(look);
  at_every_pose<LimitedHingeFixture>(look);
  at_every_pose<SliderFixture>(look);
  at_every_pose<LimitedSliderFixture>(look);
  at_every_pose<WeldFixture>(look);
}
// Hinge, slider and weld, and their parts.
template <class Look>
void for_every_turn(Look look) {
  at_every_pose<AxisFixture>(look);
  at_every_pose<HingeAngleFixture>(look);
  at_every_pose<LineFixture>(look);
  at_every_pose<RotationLockFixture>(look);
  at_every_pose<SlideFixture>(look);
  for_every_joint(look);
}
template <class Look>
void for_every_part(Look look) {
  for_every_push(look);
  for_every_turn(look);
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

TEST_CASE("I1 J times V is the rate at which the error of a moving pair changes") {
  for_every_push([](const auto& part, const Pair& pair) {
    Random random(11);
    Pair moving = pair;
    for (Body* body : {&moving.body1, &moving.body2}) {
      body->v = random.vector(real(0.6));
      body->w = random.vector(real(0.6));
    }
    Pair before = moving, after = moving;
    for (Body* body : {&before.body1, &before.body2}) integrate_pose(*body, -difference_step);
    for (Body* body : {&after.body1, &after.body2}) integrate_pose(*body, difference_step);
    const Numeric now(part, moving.body1, moving.body2);
    const Column rate = (Numeric(part, after.body1, after.body2).C -
                         Numeric(part, before.body1, before.body2).C) /
                        (2 * double(difference_step));
    const Column JV = now.J * velocities({moving.body1, moving.body2});
    CHECK((rate - JV).largest() < difference_tolerance);
  });
}

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

TEST_CASE("I2 K is J M^-1 J^T and symmetric and positive while one body can move") {
  for_every_part([](const auto& part, const Pair& pair) {
    const Body wall = static_body(pair.body1.x, pair.body1.q);
    for (const Body& one : {pair.body1, wall}) {
      const Numeric at(part, one, pair.body2);
      const Dense K = at.J * inverse_masses({one, pair.body2}) * at.J.transpose();
      CHECK((at.K - K).largest() < tolerance(1e-12, 1e-5) * K.largest());
      CHECK((at.K - at.K.transpose()).largest() < tolerance(1e-15, 1e-6) * K.largest());
      CHECK(symmetric_eigenvalues(at.K)[0] > 0);
    }
    const Body rock = static_body(pair.body2.x, pair.body2.q);
    CHECK(Numeric(part, wall, rock).K.largest() == 0);
  });
}

TEST_CASE("I2 in no direction does a ball joint feel less than the two masses in series") {
  at_every_pose<PointFixture>([](const Point& part, const Pair& pair) {
    const double mm = double(pair.body1.inverse_mass + pair.body2.inverse_mass);
    const double least = symmetric_eigenvalues(Numeric(part, pair.body1, pair.body2).K)[0];
    CHECK(least > mm * (1 - tolerance(1e-12, 1e-5)));
    // beside a wall the lever itself is that direction: a push along it turns nothing
    const Body wall = static_body(pair.body1.x, pair.body1.q);
    const Dense K = Numeric(part, wall, pair.body2).K;
    CHECK(symmetric_eigenvalues(K)[0] ==
          Approx(double(pair.body2.inverse_mass)).epsilon(tolerance(1e-12, 1e-5)));
  });
}

TEST_CASE("I7 only the gap of a point lets a part turn a free pair and nothing lets it push one") {
  // rods push along the gap itself, so nothing is left; a ball joint has u x e, zero only at C = 0
  for_every_part([](const auto& part, const Pair& pair) {
    const Numeric at(part, pair.body1, pair.body2);
    constexpr bool has_point = requires { part.first.anchor1_local; part.second.a1_local; } ||
                               requires { part.first.second.a1_local; } ||
                               std::is_same_v<std::decay_t<decltype(part)>, Weld> ||
                               std::is_same_v<std::decay_t<decltype(part)>, Point>;
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

TEST_CASE("I2 and I8 a pair that is turned and moved as one keeps its errors and its K") {
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
  // those of a point turn with the pair, number by number
  for_every_push([](const auto& part, const Pair& pair) {
    Random random(12);
    Pair other = pair;
    move_together(other, random);
    const Numeric here(part, pair.body1, pair.body2), there(part, other.body1, other.body2);
    const double near = tolerance(1e-12, 1e-5);
    const dmat3 R = rotation_matrix(other.body1) * transpose(rotation_matrix(pair.body1));
    Dense turn = Dense::identity(here.C.size());
    for (int i = 0; i < 9 && turn.size() == 9; ++i) turn(i / 3, i % 3) = R[i % 3][i / 3];
    CHECK((there.C - turn * here.C).largest() < near);
    CHECK((there.K - turn * here.K * turn.transpose()).largest() < near * here.K.largest());
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
    CHECK(Axis::far_off(to_world(pair.body1, part.a1_local), to_world(pair.body2, part.b_local),
                        to_world(pair.body2, part.c_local)) == far);
    CHECK(size == Approx(far ? double(angle) : std::sin(double(angle)))
                      .margin(tolerance(1e-12, 2e-6)));
  }
}

TEST_CASE("I28 a quaternion and its negative are the same orientation to every part") {
  const auto within = [](double near) {
    return [=](const auto& part, const Pair& pair) {
      const Numeric plain(part, pair.body1, pair.body2);
      for (int which = 1; which <= 3; ++which) {
        Body a = pair.body1, b = pair.body2;
        if (which & 1) a.q = -a.q;
        if (which & 2) b.q = -b.q;
        const Numeric other(part, a, b);
        CHECK((other.C - plain.C).largest() <= near);
        CHECK((other.J - plain.J).largest() <= near);
        CHECK((other.K - plain.K).largest() <= near * plain.K.largest());
      }
    };
  };
  for_every_push(within(tolerance(1e-14, 1e-6)));
  for_every_turn(within(0));  // not a bit
}

TEST_CASE("I27 where two points coincide a rod has no row and all its numbers are finite") {
  for_every_push([](const auto& part, const Pair& pair) {
    Pair together = pair;  // the two ends of the part in the same place, to the last bit
    auto touching = part;
    if constexpr (requires { touching.rod.anchor1_local; })
      touching.rod.anchor1_local = touching.rod.anchor2_local = vec3(0);
    if constexpr (requires { touching.anchor1_local; })
      touching.anchor1_local = touching.anchor2_local = vec3(0);
    together.body2.x = together.body1.x;
    const Numeric at(touching, together.body1, together.body2);
    CHECK(at.all_finite());
    if (at.C.size() == 1) CHECK(at.J.largest() == 0);
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
