// The stability suite, cases X2, X5, X6 and X14 of chapters 1 and 2: feedback from too little to
// too much, points that coincide, bodies that cannot move, closed loops.
#include "chapters/01_distance/distance_joint.h"
#include "tests/checker/catch.h"
#include "tests/oracle/rigs.h"

using namespace joints;
using namespace joints::testing;

namespace {

const real h = real(1) / 60;

}  // namespace

TEST_CASE("X2 the error of one joint changes by 1 - beta a step and grows beyond beta 2") {
  for (real beta : {0.05, 0.1, 0.2, 0.5, 0.9, 1.0, 1.1, 1.5, 1.9, 1.99, 2.0, 2.05, 2.2}) {
    World world;
    world.gravity = vec3(0);
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
    World world;
    world.gravity = vec3(0);
    const BodyId wall = world.add(static_body(vec3(1, 2, 3)));
    const BodyId a = world.add(ball(2, 1, vec3(1, 2, 3)));
    const BodyId b = world.add(box(2, vec3(1, 2, 3), vec3(1, 2, 3)));
    auto& centre = world.add<CentreDistanceJoint>(wall, a, CentreDistance{1});
    auto& rod = world.add<DistanceJoint>(wall, b, Distance{vec3(0), vec3(0), 1});
    SequentialImpulses solver;
    Stepping stepping;
    stepping.warm_start = warm;
    for (int n = 0; n < 10; ++n) step(world, solver, h, stepping);
    for (BodyId id : {a, b}) {
      CHECK(world.bodies[id].x == vec3(1, 2, 3));
      CHECK(world.bodies[id].v == vec3(0));
      CHECK(world.bodies[id].w == vec3(0));
    }
    CHECK(double(centre.impulse()[0]) == 0);  // what pushes nothing is no force either
    CHECK(double(rod.impulse()[0]) == 0);
    // now they part: the rod pushes its length in the share beta a step, and not a bit more
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
    Stepping stepping;
    stepping.warm_start = warm;
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
    Stepping stepping;
    stepping.warm_start = warm;
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
  Stepping stepping;
  stepping.warm_start = true;
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

TEST_CASE("X14 a closed four-bar linkage swings as far as its bars let it and stays closed") {
  World world;  // ground, two cranks of 1 m, a coupler of 2 m: a parallelogram of 12 rows, rank 11
  const BodyId ground = world.add(static_body(vec3(0)));
  const auto bar = [&](const vec3& x, real length, const quat& q) {
    return world.add(box(length, vec3(length, real(0.1), real(0.1)), x, q));
  };
  const quat up = rotation(vec3(0, 0, real(1.5707963267948966)));
  const BodyId left = bar(vec3(0, real(-0.5), 0), 1, up);
  const BodyId right = bar(vec3(2, real(-0.5), 0), 1, up);
  const BodyId coupler = bar(vec3(1, -1, 0), 2, quat(1, 0, 0, 0));
  const auto pin = [&](BodyId a, BodyId b, const vec3& p) {
    world.add<BallJoint>(a, b, point_at(world.bodies[a], world.bodies[b], p));
  };
  pin(ground, left, vec3(0));
  pin(ground, right, vec3(2, 0, 0));
  pin(left, coupler, vec3(0, -1, 0));
  pin(right, coupler, vec3(2, -1, 0));
  world.bodies[coupler].v = vec3(2, 0, 0);
  world.bodies[left].w = world.bodies[right].w = vec3(0, 0, 2);
  world.bodies[left].v = world.bodies[right].v = vec3(1, 0, 0);
  SequentialImpulses solver;
  double highest = -1, impulse = 0;
  for (int n = 0; n < 600; ++n) {
    step(world, solver, h);
    REQUIRE(all_finite(world));
    impulse = std::max(impulse, largest_impulse(world));
    highest = std::max(highest, double(world.bodies[coupler].x.y));
    for (const auto& joint : world.joints()) {
      const auto& ball = static_cast<const BallJoint&>(*joint);
      CHECK(double(length(ball.part.error(world.bodies[ball.body1], world.bodies[ball.body2]))) <
            0.02);
    }
  }
  // energy 2 kg 2 m/s and 2 x 1/3 kg m^2 (2 rad/s)^2 /2: lifts 2 kg by z and 2 kg by z/2
  CHECK(highest == Approx(-1 + (4 + 4.0 / 3) / (3 * 9.81)).epsilon(0.02));
  CHECK(impulse < 5);  // weight of all is 0.65 N s a step
}

TEST_CASE("X14 a chain of four balls between static ends bears a kick") {
  World world;
  std::vector<BodyId> ids;
  for (int k = 0; k < 5; ++k) {
    const vec3 x(real(k), 0, 0);
    ids.push_back(world.add(k == 0 || k == 4 ? static_body(x) : box(1, vec3(real(0.8)), x)));
  }
  for (std::size_t k = 1; k < 5; ++k)  // anchors in the centre of the one before, as in T 5.1
    world.add<BallJoint>(ids[k - 1], ids[k],
                         point_at(world.bodies[ids[k - 1]], world.bodies[ids[k]],
                                  world.bodies[ids[k - 1]].x));
  SequentialImpulses solver;
  double impulse = 0, speed = 0;
  for (int n = 0; n < 600; ++n) {
    if (n == 60) world.bodies[ids[1]].v = vec3(3, 5, -8);
    step(world, solver, h);
    REQUIRE(all_finite(world));
    impulse = std::max(impulse, largest_impulse(world));
    if (n > 300)
      for (BodyId id : ids) speed = std::max(speed, double(length(world.bodies[id].v)));
  }
  CHECK(impulse < 100);
  CHECK(speed < 10);  // never faster than it was kicked
}
