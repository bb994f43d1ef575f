// Position projection with every kind of joint and with awkward scenes: redundant rows, static
// bodies, points that coincide, joints that were removed, joints that take no part.
#include "engine/steps/projection.h"
#include "tests/checker/joint_fixtures.h"
#include "tests/oracle/allocations.h"
#include "tests/oracle/beside.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;
const vec3 axis(1, 2, 3), anchor(real(0.4), 0, 0);

// What a joint's rows are off by, all together.
double error_of(Joint& joint, World& world) {
  Blocks blocks;
  joint.begin_step(world.bodies, h);
  joint.append(world.bodies, blocks);
  double sum = 0;
  for (const real C : blocks.C) sum += double(C * C);
  return std::sqrt(sum);
}

// A hinge, slider or weld whose second body has been moved and turned away.
struct Apart {
  World world;
  BodyId one, two;
  Joint* joint = nullptr;

  Apart(int kind, bool free, bool whole, double size) {
    world.gravity = vec3(0);
    const quat q1 = rotation(vec3(real(0.3), 0, 1));
    one = world.add(free ? body_with(3, vec3(1, 2, real(1.5)), vec3(0), q1)
                         : static_body(vec3(0), q1));
    two = world.add(body_with(2, vec3(real(0.5), real(0.7), 1), vec3(1, real(0.3), 0),
                              rotation(vec3(1, 0, 0))));
    const auto take = [&](auto& made) {
      made.whole = whole;
      joint = &made;
    };
    if (kind == 0) take(world.add<HingeJoint>(one, two, anchor, axis));
    if (kind == 1) take(world.add<SliderJoint>(one, two, anchor, axis));
    if (kind == 2) take(world.add<FixedJoint>(one, two, anchor));
    world.bodies[two].x += real(size) * vec3(real(0.2), real(-0.1), real(0.15));
    turn_about(world.bodies[two], world.bodies[two].x,
               rotation(real(size) * vec3(real(0.3), real(0.2), real(-0.3))));
  }
};

// Bars of 1 m on ball joints, let go level.
struct Bars {
  World world;
  std::vector<BodyId> ids;
  std::vector<BallJoint*> joints;
  SequentialImpulses solver;
  StepOptions stepping{};

  explicit Bars(int links, int twice = 1) {
    ids.push_back(world.add(static_body(vec3(0))));
    for (int k = 0; k < links; ++k) {
      ids.push_back(world.add(box(1, vec3(1, real(0.1), real(0.1)),
                                  vec3(real(k) + real(0.5), 0, 0))));
      const BodyId before = ids[std::size_t(k)];
      for (int n = 0; n < twice; ++n) {
        joints.push_back(&world.add<BallJoint>(
            before, ids.back(),
            point_at(world.bodies[before], world.bodies[ids.back()], vec3(real(k), 0, 0))));
        joints.back()->beta = 0;
      }
    }
  }
  double gap(std::size_t k) const {
    return double(length(joints[k]->part.error(world.bodies[joints[k]->body1],
                                               world.bodies[joints[k]->body2])));
  }
  void run(int steps) {
    for (int n = 0; n < steps; ++n) step(world, solver, h, stepping);
  }
};

}  // namespace

TEST_CASE("projection closes a hinge whose limit has a gap as one without limits") {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const auto moved = [&](bool limited) {
      Apart apart(0, true, true, 0);
      Random random(seed);
      auto& hinge = static_cast<HingeJoint&>(*apart.joint);
      Body& body = apart.world.bodies[apart.two];
      body.x += random.vector(real(0.05));
      body.q = normalize(rotation(random.vector(real(0.1))) * body.q);
      const real now = hinge.position(apart.world.bodies);
      if (limited) hinge.set_limits(now - 1, now + real(1e-3));
      hinge.begin_step(apart.world.bodies, h);
      CHECK(hinge.stats().live_limits == int(limited));
      project_positions(apart.world);
      return std::pair{body.x, body.q};
    };
    CHECK(moved(true) == moved(false));
  }
}

TEST_CASE("I20 projection closes a whole hinge or slider or weld with the square of what is left") {
  for (const int kind : {0, 1, 2})
    for (const bool free : {false, true}) {
      CAPTURE(kind, free);
      Apart apart(kind, free, true, 0.3);  // no projection reaches its bounds
      double last = error_of(*apart.joint, apart.world);
      CHECK(last > 0.05);
      for (int n = 0; n < 5; ++n) {
        project_positions(apart.world);
        const double now = error_of(*apart.joint, apart.world);
        CHECK(now < std::max(0.5 * last * last, tolerance(1e-14, 1e-6)));
        last = now;
      }
      CHECK(last < tolerance(1e-14, 1e-6));  // the floor of its numbers
    }
}

TEST_CASE("projection closes joints in blocks apart as their blocks let it") {
  for (const int kind : {0, 1, 2}) {
    Apart apart(kind, true, false, 1);
    for (int n = 0; n < 100; ++n) project_positions(apart.world);
    CHECK(error_of(*apart.joint, apart.world) < tolerance(1e-9, 1e-6));
  }
}

TEST_CASE("X14 projected two identical ball joints do what one does") {
  Bars one(2, 1), two(2, 2);
  one.stepping.projections = two.stepping.projections = 4;
  one.solver.iterations = two.solver.iterations = 200;
  for (int step = 0; step < 120; ++step) {
    one.run(1);
    two.run(1);
    REQUIRE(all_finite(two.world));
    for (std::size_t k = 0; k < 4; ++k)
      CHECK(std::abs(two.gap(k) - one.gap(k / 2)) < tolerance(1e-5, 1e-4));
    CHECK(double(length(one.world.bodies[one.ids[2]].x - two.world.bodies[two.ids[2]].x)) <
          tolerance(1e-4, 1e-2));
  }
}

TEST_CASE("X14 projected two identical welds come together as one does") {
  for (const bool whole : {true, false}) {
    Apart apart(2, true, whole, 1);
    const auto& first = static_cast<const FixedJoint&>(*apart.joint);
    auto& second = apart.world.add<FixedJoint>(first.body1, first.body2, vec3(0));
    second.weld = first.weld;
    second.whole = first.whole;
    second.beta = first.beta;
    for (int n = 0; n < 60; ++n) project_positions(apart.world);
    CHECK(all_finite(apart.world));
    CHECK(error_of(second, apart.world) < tolerance(1e-9, 1e-6));
  }
}

TEST_CASE("X6 projection moves no static body and nothing between two of them") {
  World world;
  const BodyId a = world.add(static_body(vec3(1, 2, 3), rotation(vec3(1, 0, 2))));
  const BodyId b = world.add(static_body(vec3(5, 0, 0)));
  world.add<BallJoint>(a, b, Point{});
  world.add<FixedJoint>(a, b, vec3(0));
  auto& hinge = world.add<HingeJoint>(a, b, vec3(0), axis);
  hinge.set_limits(1, 2);
  const std::vector<Body> before = snapshot(world.bodies);
  SequentialImpulses solver;
  StepOptions stepping{.projections = 3};
  for (int n = 0; n < 100; ++n) step(world, solver, h, stepping);
  CHECK(same_bits(world.bodies[a], before[0]));
  CHECK(same_bits(world.bodies[b], before[1]));
}

TEST_CASE("X5 projection pushes nothing in a direction that is not there") {
  World world = weightless();
  const BodyId a = world.add(box(2, vec3(1), vec3(0))), b = world.add(box(3, vec3(1), vec3(0)));
  world.add<DistanceJoint>(a, b, Distance{vec3(0), vec3(0), 1});
  world.add<RopeJoint>(a, b, Rope<Distance>{{vec3(0), vec3(0), 0}});
  for (int n = 0; n < 10; ++n) project_positions(world);
  CHECK(world.bodies[a].x == vec3(0));
  CHECK(world.bodies[b].x == vec3(0));
  world.bodies[b].x = vec3(real(1e-3), 0, 0);  // now there is one: the rod and the rope disagree
  for (int n = 0; n < 10; ++n) project_positions(world);
  CHECK(all_finite(world));
}

TEST_CASE("projection leaves a slack rope alone to the last bit and shortens a long one") {
  for (const double length_of_rope : {4.0, 3.0}) {
    World world;
    const BodyId a = world.add(static_body(vec3(0)));
    const BodyId b = world.add(box(2, vec3(1, 2, 3), vec3(2, 2, 3), rotation(vec3(1, 2, 3))));
    auto& rope = world.add<RopeJoint>(
        a, b, Rope<Distance>{{vec3(0), vec3(real(0.1), 0, 0), real(length_of_rope)}});
    const bool slack = rope.part.error(world.bodies[a], world.bodies[b]) > 0;
    const Body before = world.bodies[b];
    for (int n = 0; n < 20; ++n) project_positions(world);
    CHECK(same_bits(world.bodies[b], before) == slack);
    if (slack) continue;
    const double left = double(rope.part.error(world.bodies[a], world.bodies[b]));
    CHECK(left > -tolerance(1e-12, 1e-5));  // not too long any more
    CHECK(left < 1e-4);                     // and shortened by no more than a second order
  }
}

TEST_CASE("X7 projection alone brings a hinge back from 90 and 180 degrees and never upside down") {
  for (const double angle : {90.0, 179.9, 180.0})
    for (const real sign : {real(1), real(-1)}) {
      World world = weightless();
      const BodyId one = world.add(static_body(vec3(0), rotation(vec3(1, 0, 2))));
      const BodyId two = world.add(body_with(2, vec3(1, real(0.7), real(0.5)), vec3(1, 0, 0)));
      auto& hinge = world.add<HingeJoint>(one, two, vec3(real(0.5), 0, 0),
                                          vec3(0, 0, 1));
      turn_about(world.bodies[two], vec3(real(0.5), 0, 0),
                 rotation(vec3(real(angle) * degree, 0, 0)));
      world.bodies[two].q = sign * world.bodies[two].q;
      for (int n = 0; n < 60; ++n) project_positions(world);
      const vec3 a1 = to_world(world.bodies[one], hinge.second.a1_local);
      const vec3 a2 = to_world(world.bodies[two],
                               cross(hinge.second.b_local, hinge.second.c_local));
      CHECK(angle_between(a1, a2) < tolerance(1e-9, 1e-3));
    }
}

TEST_CASE("X13 projected without feedback a motor rests at its limit without drift") {
  for (const bool warm : {false, true}) {
    Crane crane(vec3(0, 1, 0));
    crane.hinge->set_motor(3, 500);
    crane.hinge->set_limits(-60 * degree, 60 * degree);
    crane.hinge->beta = 0;
    crane.stepping.warm_start = warm;
    crane.stepping.projections = 1;
    double low = 1e9, high = -1e9;
    for (int n = 0; n < 1800; ++n) {
      step(crane.world, crane.solver, h, crane.stepping);
      high = std::max(high, std::abs(crane.in_degrees()));
      if (n > 600) low = std::min(low, std::abs(crane.in_degrees()));
    }
    CHECK(std::abs(high - 60) < 0.01);
    CHECK(std::abs(low - 60) < 0.01);
  }
}

TEST_CASE("X11 projection reaches a limit beyond half a turn and its turns are counted") {
  for (const auto& [lower, upper] : {std::pair{5, 5}, {5, 6}, {10, 11}, {-11, -10}})
    for (const int projections : {1, 4, 20}) {
      Rotor rotor;
      rotor.hinge->set_limits(real(lower), real(upper));
      rotor.stepping.projections = projections;
      rotor.run(300, h);
      CAPTURE(lower, upper, projections);
      CHECK(rotor.angle() > lower - tolerance(1e-9, 1e-4));
      CHECK(rotor.angle() < upper + tolerance(1e-9, 1e-4));
      CHECK(std::abs(double(rotor.rotor().w.z)) < tolerance(1e-9, 1e-4));
    }
}

TEST_CASE("a joint without projection keeps its gap and its neighbours close theirs") {
  Bars all(4), but_one(4);
  but_one.joints[2]->projected = false;
  for (Bars* bars : {&all, &but_one}) {
    bars->stepping.projections = 10;
    bars->run(120);
  }
  for (const std::size_t k : {0, 1, 2, 3}) CHECK(all.gap(k) < tolerance(1e-4, 1e-4));
  for (const std::size_t k : {0, 1, 3}) CHECK(but_one.gap(k) < tolerance(1e-4, 1e-4));
  CHECK(but_one.gap(2) > 1e-2);
}

TEST_CASE("a removed joint or body is projected no more and the others go on") {
  Bars bars(4);
  bars.stepping.projections = 4;
  bars.run(30);
  bars.world.remove(*bars.joints[3]);  // the last bar falls
  const real height = bars.world.bodies[bars.ids[4]].x.y;
  bars.run(60);
  CHECK(bars.world.bodies[bars.ids[4]].x.y < height - 3);
  for (const std::size_t k : {0, 1, 2}) CHECK(bars.gap(k) < tolerance(1e-3, 1e-3));
  bars.world.remove(bars.ids[2]);  // and the second is gone with both its joints
  bars.run(60);
  CHECK(all_finite(bars.world));
  CHECK(bars.world.joints().size() == 1);
  CHECK(bars.gap(0) < tolerance(1e-4, 1e-4));
}

TEST_CASE("projection reaches the floor of its numbers in every joint of a swinging chain") {
  Bars bars(4);
  bars.stepping.projections = 100;
  for (int step = 0; step < 300; ++step) {
    bars.run(1);
    for (std::size_t k = 0; k < 4; ++k) CHECK(bars.gap(k) < tolerance(1e-9, 3e-6));
  }
}

TEST_CASE("projection allocates in no step but the first") {
  Bars bars(6);
  bars.stepping.projections = 3;
  bars.world.add<FixedJoint>(bars.ids[0], bars.ids[1], vec3(0));
  bars.run(1);
  CHECK(allocations_of([&] { bars.run(50); }) == 0);
}

TEST_CASE("projection that is off leaves every bit as a step without it has it") {
  Bars off(4), flag(4), by_hand(4);
  for (BallJoint* joint : flag.joints) joint->projected = false;
  for (int step = 0; step < 100; ++step) {
    off.run(1);
    flag.run(1);
    begin_step(by_hand.world, by_hand.solver, h, by_hand.stepping);
    for (int k = 0; k < 30; ++k) by_hand.solver.iterate(by_hand.world.bodies);
    for (int slot = 0; slot < by_hand.world.bodies.slots(); ++slot)
      integrate_pose(by_hand.world.bodies.at(slot), h);
  }
  CHECK(same_bodies(off.world, by_hand.world));
  CHECK(same_bodies(off.world, flag.world));
  flag.stepping.projections = 5;  // on, with nobody who takes part
  off.run(10);
  flag.run(10);
  CHECK(same_bodies(off.world, flag.world));
}
