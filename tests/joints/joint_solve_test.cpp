// What one exact solve of a whole hinge, slider or weld does, and of the parts it is made of: the
// rows hold, a second solve finds nothing, energy and momentum change by what the formulas say.
#include "engine/instruments/measure.h"
#include "tests/checker/catch.h"
#include "tests/checker/joint_fixtures.h"
#include "tests/oracle/rigs.h"
#include "tests/joints/any_part.h"

using namespace joints;
using namespace joints::testing;

namespace {

const real h = real(1) / 60;

template <class Fixture>
struct Broken : Fixture {
  static constexpr bool exact_when_broken = true;
};

// One joint between two moving bodies, before and after one iteration.
struct Solved {
  System system;
  Column lambda, second, bias, V1, V2;
  Dense W, K;
  std::vector<Body> before, after;

  template <class Part>
  Solved(const Part& part, const Pair& pair, real beta) {
    World world;
    world.gravity = vec3(0);
    const BodyId a = world.add(pair.body1), b = world.add(pair.body2);
    world.add<PartJoint<Part>>(a, b, part).beta = beta;
    SequentialImpulses solver;
    begin_step(world, solver, h);  // at rest: no gyroscopic torque
    Random random(71);
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
  double size() const {  // of what the solve had to take away
    return std::max(1.0, (system.J * V1 + bias).largest());
  }
  // In float a block near to singular costs digits: as many as its condition number has.
  double loss() const {
    const Column eigen = symmetric_eigenvalues(K);
    return std::max(1.0, eigen[eigen.size() - 1] / eigen[0] / 30);
  }
};

template <class Look>
void for_every_solve(Look look) {
  for (real beta : {real(0), real(0.2)}) {
    const auto at = [&](int, const auto& part, const Pair& pair) {
      look(Solved(part, pair, beta), beta);
    };
    for_each_pose<Broken<AxisFixture>>(at);
    for_each_pose<Broken<LineFixture>>(at);
    for_each_pose<Broken<RotationLockFixture>>(at);
    for_each_pose<Broken<HingeFixture>>(at);
    for_each_pose<Broken<SliderFixture>>(at);
    for_each_pose<Broken<WeldFixture>>(at);
  }
}

double energy(const std::vector<Body>& bodies) {
  double sum = 0;
  for (const Body& body : bodies) sum += kinetic_energy(body);
  return sum;
}

}  // namespace

TEST_CASE("I3 after one solve the rows of a whole hinge or slider or weld move as asked") {
  for_every_solve([](const Solved& s, real) {
    const Column left = s.system.J * s.V2 + s.bias;
    CHECK(left.largest() < tolerance(1e-11, 1e-4) * s.size() * s.loss());
  });
}

TEST_CASE("I4 a second solve of a whole hinge or slider or weld finds nothing left to do") {
  for_every_solve([](const Solved& s, real) {
    CHECK(s.second.largest() < tolerance(1e-11, 1e-4) * s.size() * s.loss());
  });
}

TEST_CASE("I5 a solve of a whole joint changes the energy by what its formula says") {
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

TEST_CASE("I6 of all velocities that a whole joint allows its solve takes the nearest") {
  for_every_solve([](const Solved& s, real) {
    // Gauss: V2 = V1 + M^-1 J^T lambda, with the lambda that makes J V2 = -b
    const Column lambda = solved(s.K, -(s.system.J * s.V1 + s.bias));
    const Column best = s.V1 + s.W * s.system.J.transpose() * lambda;
    CHECK(difference(s.V2, best) < tolerance(1e-10, 1e-4) * s.loss());
    CHECK(difference(s.lambda, lambda) < tolerance(1e-10, 1e-4) * s.loss());
  });
}

TEST_CASE("I7 a solve of a whole joint keeps momentum but for the gap of its point") {
  const auto look = [](bool has_point, const Solved& s) {
    dvec3 linear(0), angular = linear, gap = linear;
    const auto add = [&](const Body& body, double sign) {
      const dvec3 p = sign * dvec3(body.v) / double(body.inverse_mass);
      const dmat3 I = inertia_of(body);
      linear += p;
      angular += cross(dvec3(body.x), p) + sign * (I * dvec3(body.w));
    };
    for (const Body& body : s.after) add(body, 1);
    for (const Body& body : s.before) add(body, -1);
    if (has_point) gap = cross(three(s.system.C), three(s.lambda));
    const double size = s.size() * std::max(1.0, s.lambda.largest());
    CHECK(length(linear) < tolerance(1e-12, 1e-4) * size);
    CHECK(length(angular - gap) < tolerance(1e-12, 1e-4) * size);
  };
  for (real beta : {real(0), real(0.2)}) {
    const auto without = [&](int, const auto& part, const Pair& pair) {
      look(false, Solved(part, pair, beta));
    };
    const auto with = [&](int, const auto& part, const Pair& pair) {
      look(true, Solved(part, pair, beta));
    };
    for_each_pose<Broken<AxisFixture>>(without);
    for_each_pose<Broken<LineFixture>>(without);
    for_each_pose<Broken<RotationLockFixture>>(without);
    for_each_pose<Broken<SliderFixture>>(without);
    for_each_pose<Broken<HingeFixture>>(with);
    for_each_pose<Broken<WeldFixture>>(with);
  }
}
