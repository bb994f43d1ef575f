// The stability suite, cases X2, X5 and X6 of chapters 1 and 2: feedback from too little to too
// much, points that coincide, bodies that cannot move.
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

}  // namespace

TEST_CASE("X2 the error of one joint changes by 1 - beta a step and grows beyond beta 2") {
  for (real beta : {0.05, 0.1, 0.2, 0.5, 0.9, 1.0, 1.1, 1.5, 1.9, 1.99, 2.0, 2.05, 2.2}) {
    World world = weightless();
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId body = world.add(box(3, vec3(1), vec3(real(1.001), 0, 0)));
    auto& joint = world.add<DistanceJoint>(wall, body, Distance{vec3(0), vec3(0), 1});
    joint.beta = beta;
    SequentialImpulses solver;
    const auto error = [&] {
      return double(joint.part.error(world.bodies[wall], world.bodies[body]));
    };
    const double first = error();
    double last = first;
    for (int n = 0; n < 50; ++n) {
      if (std::abs(last) > 0.3 || std::abs(last) < tolerance(1e-8, 2e-4)) break;
      step(world, solver, h);
      INFO("beta " << beta << " n " << n);
      CHECK(std::abs(std::abs(error() / last) - std::abs(1 - double(beta))) <
            tolerance(1e-3, 5e-3));
      last = error();
    }
    if (beta < 2) CHECK(std::abs(last) < std::abs(first));
    if (beta > 2) CHECK(std::abs(last) > 3 * std::abs(first));
  }
}

TEST_CASE("X5 a rod whose ends coincide is not pushed anywhere until they part") {
  for (bool warm : {false, true}) {
    World world = weightless();
    const BodyId wall = world.add(static_body(vec3(1, 2, 3)));
    const BodyId a = world.add(ball(2, 1, vec3(1, 2, 3)));
    const BodyId b = world.add(box(2, vec3(1, 2, 3), vec3(1, 2, 3)));
    auto& centre = world.add<CentreDistanceJoint>(wall, a, CentreDistance{1});
    auto& rod = world.add<DistanceJoint>(wall, b, Distance{vec3(0), vec3(0), 1});
    SequentialImpulses solver;
    StepOptions stepping{.warm_start = warm};
    for (int n = 0; n < 10; ++n) step(world, solver, h, stepping);
    for (BodyId id : {a, b}) {
      CHECK(world.bodies[id].x == vec3(1, 2, 3));
      CHECK(world.bodies[id].v == vec3(0));
      CHECK(world.bodies[id].w == vec3(0));
    }
    CHECK(double(centre.impulse()[0]) == 0);  // what pushes nothing is no force either
    CHECK(double(rod.impulse()[0]) == 0);
    // now they part: the rod corrects the fraction beta of its error per step, and no more
    for (BodyId id : {a, b}) world.bodies[id].x += vec3(real(0.01), 0, 0);
    step(world, solver, h, stepping);
    for (BodyId id : {a, b})
      CHECK(double(world.bodies[id].v.x) == Approx(0.2 * 0.99 * 60).epsilon(tolerance(1e-9, 1e-4)));
  }
}

TEST_CASE("X5 a rope of length 0 holds two points together and two that coincide at rest") {
  for (bool warm : {false, true}) {
    World world;
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId body = world.add(ball(2, real(0.1), vec3(0)));
    world.add<CentreRopeJoint>(wall, body, Rope<CentreDistance>{{0}});
    const BodyId box_id = world.add(box(2, vec3(1), vec3(3, 0, 0)));
    world.add<RopeJoint>(wall, box_id, Rope<Distance>{{vec3(3, 0, 0), vec3(0), 0}});
    SequentialImpulses solver;
    StepOptions stepping{.warm_start = warm};
    for (int n = 0; n < 600; ++n) {
      step(world, solver, h, stepping);
      REQUIRE(all_finite(world));
      CHECK(double(length(world.bodies[body].x)) < 0.05);  // sags g h^2/beta once, no more
      CHECK(double(length(world.bodies[box_id].x - vec3(3, 0, 0))) < 0.05);
    }
  }
}

TEST_CASE("X5 a ball joint with both anchors in both centres is a ball joint") {
  World world;
  const BodyId wall = world.add(static_body(vec3(0)));
  const BodyId body = world.add(box(2, vec3(1, 2, 3), vec3(0)));
  world.bodies[body].w = vec3(1, 2, 3);
  world.add<BallJoint>(wall, body, Point{});
  SequentialImpulses solver;
  for (int n = 0; n < 100; ++n) step(world, solver, h);
  CHECK(double(length(world.bodies[body].x)) < tolerance(1e-14, 1e-6));
  CHECK(all_finite(world));
  CHECK(double(length(world.bodies[body].w)) > 2);  // free to turn
}

TEST_CASE("X6 a joint between two static bodies moves nothing in a thousand steps") {
  World world;
  const BodyId a = world.add(static_body(vec3(0))), b = world.add(static_body(vec3(5, 0, 0)));
  world.add<BallJoint>(a, b, Point{});
  world.add<DistanceJoint>(a, b, Distance{vec3(0), vec3(0), 1});
  world.add<RopeJoint>(a, b, Rope<Distance>{{vec3(0), vec3(0), 1}});
  for (bool warm : {false, true}) {
    SequentialImpulses solver;
    StepOptions stepping{.warm_start = warm};
    for (int n = 0; n < 1000; ++n) step(world, solver, h, stepping);
    CHECK(world.blocks.list.empty());
  }
  CHECK(world.bodies[a].x == vec3(0));
  CHECK(world.bodies[b].x == vec3(5, 0, 0));
  CHECK(world.bodies[b].v == vec3(0));
  CHECK(world.bodies[b].w == vec3(0));
}

TEST_CASE("X6 a joint that lost its last body that can move pulls no more") {
  World world;
  const BodyId wall = world.add(static_body(vec3(0)));
  const BodyId body = world.add(ball(3, 1, vec3(0)));
  auto& joint = world.add<BallJoint>(wall, body, Point{});
  SequentialImpulses solver;
  StepOptions stepping{.warm_start = true};
  for (int n = 0; n < 5; ++n) step(world, solver, h, stepping);
  CHECK(double(joint.impulse()[1] / h) == Approx(29.43).epsilon(1e-4));
  const Body moving = world.bodies[body];
  world.bodies[body] = static_body(vec3(0));
  for (int n = 0; n < 5; ++n) step(world, solver, h, stepping);
  world.bodies[body] = moving;
  world.gravity = vec3(0);  // nothing is left to carry: the old impulse must not come back
  solver.iterations = 1;
  begin_step(world, solver, h, stepping);
  CHECK(world.bodies[body].v == moving.v);
}
