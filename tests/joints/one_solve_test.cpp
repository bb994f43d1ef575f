// What one exact solve of one joint does, by the engine's own loop: the rows hold, energy and
// momentum change as the formulas say, and the error dies away at the promised rate.
#include "engine/instruments/measure.h"
#include "joints/fixed_joint.h"
#include "joints/hinge_joint.h"
#include "tests/checker/joint_fixtures.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

template <class Fixture>
struct Broken : Fixture {
  static constexpr bool exact_when_broken = true;
};

// One joint between two moving bodies, before and after one iteration.
struct Solved {
  System system;
  Column lambda, second;  // the impulse of the iteration, and that of a further iteration
  Column bias, V1, V2;
  Dense W, K;
  std::vector<Body> before, after;
  bool has_point;

  template <class Part>
  Solved(const Part& part, const Pair& pair, real beta, bool has_point) : has_point(has_point) {
    World world = weightless();
    const BodyId a = world.add(pair.body1), b = world.add(pair.body2);
    world.add<PartJoint<Part>>(a, b, part).beta = beta;
    SequentialImpulses solver;
    begin_step(world, solver, h);  // at rest: no gyroscopic torque
    Random random(21);
    push_at_random(world.bodies, random);
    before = snapshot(world.bodies);
    solver.iterate(world.bodies);
    after = snapshot(world.bodies);
    system = system_of(world.blocks, 2);
    lambda = impulses(world.blocks);
    solver.iterate(world.bodies);
    second = impulses(world.blocks) - lambda;
    bias = double(beta) / double(h) * system.C;
    V1 = velocities(before);
    V2 = velocities(after);
    W = inverse_masses(before);
    K = system.J * W * system.J.transpose();
  }
  // The size of the error that the solve had to remove.
  double size() const { return std::max(1.0, (system.J * V1 + bias).largest()); }
  // In float a block near to singular costs digits: as many as its condition number has.
  double loss() const {
    const Column eigen = symmetric_eigenvalues(K);
    return is_float ? std::max(1.0, eigen[eigen.size() - 1] / eigen[0] / 30) : 1;
  }
};

// Every equality part at every pose, and whole joints, with and without error feedback.
template <class Look>
void for_every_solve(Look look) {
  for (real beta : {real(0), real(0.2)}) {
    const auto solved = [&](bool has_point) {
      return [&, has_point](int, const auto& part, const Pair& pair) {
        look(Solved(part, pair, beta, has_point), beta);
      };
    };
    for_each_pose<CentreDistanceFixture>(solved(false));
    for_each_pose<DistanceFixture>(solved(false));
    for_each_pose<PointFixture>(solved(true));
    for_each_pose<Broken<AxisFixture>>(solved(false));
    for_each_pose<Broken<LineFixture>>(solved(false));
    for_each_pose<Broken<RotationLockFixture>>(solved(false));
    for_each_pose<Broken<HingeFixture>>(solved(true));
    for_each_pose<Broken<SliderFixture>>(solved(false));
    for_each_pose<Broken<WeldFixture>>(solved(true));
  }
}

double energy(const std::vector<Body>& bodies) {
  double sum = 0;
  for (const Body& body : bodies) sum += kinetic_energy(body);
  return sum;
}

}  // namespace

TEST_CASE("I3 after one exact solve the rows move as they were asked to") {
  for_every_solve([](const Solved& s, real) {
    const Column left = s.system.J * s.V2 + s.bias;
    CHECK(left.largest() < tolerance(1e-11, 1e-4) * s.size() * s.loss());
  });
}

TEST_CASE("I4 a second solve finds nothing left to do") {
  for_every_solve([](const Solved& s, real) {
    CHECK(s.second.largest() < tolerance(1e-11, 1e-4) * s.size() * s.loss());
  });
}

TEST_CASE("I5 a solve gives b K^-1 b over 2 of energy and takes J V K^-1 J V over 2") {
  for_every_solve([](const Solved& s, real beta) {
    const Column JV = s.system.J * s.V1;
    const Dense inverse = inverse_of(s.K);
    const double given = 0.5 * dot(s.bias, inverse * s.bias), taken = 0.5 * dot(JV, inverse * JV);
    const double start = energy(s.before), change = energy(s.after) - start;
    CHECK(std::abs(change - (given - taken)) <
          tolerance(1e-11, 1e-4) * (given + taken + start) * s.loss());
    if (beta == 0) CHECK(change <= tolerance(1e-12, 1e-5) * start);
  });
}

TEST_CASE("I6 of all velocities that the rows allow a solve takes the nearest") {
  for_every_solve([](const Solved& s, real) {
    const long n = s.lambda.size();  // Gauss: least (V - V1) M (V - V1)/2 with J V = -b
    Dense KKT(12 + n, 12 + n);
    KKT.add(0, 0, inverse_of(s.W));
    KKT.add(0, 12, -s.system.J.transpose());
    KKT.add(12, 0, s.system.J);
    Column right(12 + n);
    right.add(0, 0, inverse_of(s.W) * s.V1);
    right.add(12, 0, -s.bias);
    const Column best = solved(KKT, right);
    CHECK(difference(s.V2, best.rows_from(0, 12)) < tolerance(1e-10, 1e-4) * s.loss());
    CHECK(difference(s.lambda, best.rows_from(12, n)) < tolerance(1e-10, 1e-4) * s.loss());
  });
}

TEST_CASE("I7 a solve keeps the momentum and turns the pair by the gap times the impulse") {
  for_every_solve([](const Solved& s, real) {
    dvec3 linear(0), angular = linear, gap = linear;
    const auto add = [&](const Body& body, double sign) {
      const dvec3 p = sign * dvec3(body.v) / double(body.inverse_mass);
      linear += p;
      angular += cross(dvec3(body.x), p) + sign * (inertia_of(body) * dvec3(body.w));
    };
    for (const Body& body : s.after) add(body, 1);
    for (const Body& body : s.before) add(body, -1);
    if (s.has_point) gap = cross(three(s.system.C), three(s.lambda));
    const double size = s.size() * (s.lambda.size() > 3 ? std::max(1.0, s.lambda.largest()) : 1);
    CHECK(length(linear) < tolerance(1e-12, 1e-4) * size);
    CHECK(length(angular - gap) < tolerance(1e-12, 1e-4) * size);
  });
}

TEST_CASE("I11 the error of a row that keeps its direction shrinks by 1 - beta every step") {
  const auto check_decay = [](auto part, const vec3& start, real beta) {
    World world = weightless();
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId body = world.add(ball(3, real(0.5), start));
    auto& joint = world.add<PartJoint<decltype(part)>>(wall, body, part);
    joint.beta = beta;
    SequentialImpulses solver;
    const auto error = [&] {
      return to_vector(joint.part.error(world.bodies[wall], world.bodies[body]));
    };
    const auto first = error();
    for (int n = 1; n <= 20; ++n) {
      step(world, solver, h);
      const auto now = error();
      const double share = std::pow(1 - double(beta), n);
      for (std::size_t i = 0; i < now.size(); ++i)
        CHECK(std::abs(double(now[i]) - share * double(first[i])) <=
              tolerance(1e-10 * share * std::abs(double(first[i])) + 1e-15, 1e-6));
    }
  };
  for (real beta : {real(0.15), real(0.2), real(0.5)}) {
    check_decay(CentreDistance{1}, vec3(real(1.4), 0, 0), beta);
    check_decay(Point{}, vec3(real(0.3), real(-0.2), real(0.5)), beta);
  }
}

TEST_CASE("I11 with a lever and an error of 1 mm a step leaves 0.85 of it") {
  const vec3 lever(real(0.5), real(0.3), real(-0.2));
  const vec3 off(real(6e-4), real(-0.48e-3), real(0.64e-3));  // 1 mm long
  World world = weightless();
  const BodyId wall = world.add(static_body(vec3(0)));
  const BodyId body = world.add(box(3, vec3(1, 2, real(0.5)), off - lever));
  auto& joint = world.add<BallJoint>(wall, body, Point{vec3(0), lever});
  joint.beta = real(0.15);
  SequentialImpulses solver;
  double last = double(length(joint.part.error(world.bodies[wall], world.bodies[body])));
  CHECK(last == Approx(1e-3).epsilon(tolerance(1e-12, 1e-3)));
  for (int n = 0; n < (is_float ? 1 : 10); ++n) {
    step(world, solver, h);
    const double now = double(length(joint.part.error(world.bodies[wall], world.bodies[body])));
    CHECK(now / last == Approx(0.85).epsilon(1e-3));
    last = now;
  }
}

TEST_CASE("I25 a static body is still at rest to the last bit after a thousand steps") {
  for (bool warm : {false, true}) {
    World world;
    const BodyId left = world.add(static_body(vec3(0), rotation(vec3(real(0.3)))));
    const BodyId right = world.add(static_body(vec3(4, 0, 0)));
    const BodyId a = world.add(box(1, vec3(1, real(0.2), real(0.3)), vec3(1, 0, 0)));
    const BodyId b = world.add(box(50, vec3(1, real(0.2), real(0.3)), vec3(3, 0, 0)));
    const Bodies& bodies = world.bodies;
    world.add<BallJoint>(left, a, point_at(bodies[left], bodies[a], vec3(real(0.5), 0, 0)));
    world.add<BallJoint>(b, right, point_at(bodies[b], bodies[right], vec3(real(3.5), 0, 0)));
    world.add<DistanceJoint>(a, b, Distance{vec3(real(0.4), 0, 0), vec3(0), real(1.8)});
    world.add<RopeJoint>(left, b, Rope<Distance>{{vec3(0), vec3(0), 3}});
    world.add<BallJoint>(left, right, Point{});  // nothing can close this gap
    const Body before_left = bodies[left], before_right = bodies[right];
    SequentialImpulses solver;
    StepOptions stepping{.warm_start = warm};
    for (int n = 0; n < 1000; ++n) step(world, solver, h, stepping);
    const auto same_bits = [](const auto& one, const auto& other) {
      return std::memcmp(&one, &other, sizeof one) == 0;
    };
    for (const auto& [now, before] : {std::pair{bodies[left], before_left},
                                      std::pair{bodies[right], before_right}}) {
      CHECK(same_bits(now.v, vec3(0)));
      CHECK(same_bits(now.w, vec3(0)));
      CHECK(same_bits(now.x, before.x));
      CHECK(same_bits(now.q, before.q));
    }
    CHECK(finite(bodies[b].x));
  }
}
