// Joints that were opened by hand: the speed at which they are closed has a bound.
#include <functional>

#include "engine/steps/step.h"
#include "joints/ball_joint.h"
#include "joints/fixed_joint.h"
#include "joints/hinge_joint.h"
#include "tests/joints/three_solvers.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;
using AddJoint = std::function<Joint&(World&, BodyId, BodyId, real)>;

const AddJoint kinds[] = {
    [](World& world, BodyId a, BodyId b, real) -> Joint& {
      return world.add<BallJoint>(a, b, vec3(0));
    },
    [](World& world, BodyId a, BodyId b, real) -> Joint& {
      return world.add<HingeJoint>(a, b, vec3(0), vec3(0, 0, 1));
    },
    [](World& world, BodyId a, BodyId b, real) -> Joint& {
      return world.add<FixedJoint>(a, b, vec3(0));
    },
    [](World& world, BodyId a, BodyId b, real size) -> Joint& {
      return world.add<DistanceJoint>(a, b, vec3(-size, 0, 0), vec3(size, 0, 0));
    }};

}  // namespace

TEST_CASE("a joint opened by hand is closed at its push, or at beta C / h where that is less") {
  const double exact = tolerance(1e-6, 1e-3);
  int bounded = 0, free = 0;
  for (const auto& solver : three_solvers(300)) {
    Random random(43);
    for (int draw = 0; draw < 40; ++draw) {
      World world;
      world.gravity = vec3(0);
      const real size = std::exp(random.uniform(-3, 3));
      const BodyId a = world.add(box(1, vec3(size), vec3(-size, 0, 0)));
      const BodyId b = world.add(box(random.uniform(1, 5), vec3(size), vec3(size, 0, 0)));
      Joint& joint = kinds[draw % 4](world, a, b, size);
      joint.push = std::exp(random.uniform(-2, 4));
      world.bodies[b].x += size * std::exp(random.uniform(-2, 3)) * drawn_direction(random);
      const quat turn(1, random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      world.bodies[b].q = normalize(turn);
      begin_step(world, *solver, h);
      solver->solve(world.bodies);
      for (const Block& block : world.blocks.list)
        for (int i = block.first; i < block.first + block.rows; ++i) {
          const real wanted = joint.beta / h * world.blocks.C[std::size_t(i)];
          (std::abs(wanted) > joint.push ? bounded : free)++;
          CAPTURE(draw, i, double(size), double(joint.push), double(wanted));
          const real rate =
              row_velocity(world.blocks.J[std::size_t(i)], world.bodies.at(block.body1),
                           world.bodies.at(block.body2));
          const real right = -std::clamp(wanted, -joint.push, joint.push);
          CHECK(double(rate) == Approx(double(right)).epsilon(exact).margin(exact));
        }
    }
  }
  CHECK(bounded > 50);
  CHECK(free > 50);
}

TEST_CASE("a push that is not positive is refused") {
  World world;
  const BodyId wall = world.add(static_body(vec3(0)));
  Joint& joint = world.add<BallJoint>(wall, world.add(box(1, vec3(1), vec3(1, 0, 0))), vec3(0));
  SequentialImpulses solver;
  for (const real push : {real(0), real(-1), real(NAN)}) {
    joint.push = push;
    CHECK_THROWS_AS(step(world, solver, h), std::invalid_argument);
  }
}
