// What reduced coordinates refuse, and that the sentence names the joint; changes between steps.
#include "joints/distance_joint.h"
#include "tests/oracle/allocations.h"
#include "tests/oracle/beside.h"
#include "tests/oracle/test.h"
#include "tests/reduced/drawn_trees.h"

namespace {

const real h = real(1) / 60;

// A chain of cubes on hinges that hangs on a static body.
World chain(int length) {
  World world;
  std::vector<BodyId> ids{world.add(static_body(vec3(0)))};
  for (int k = 1; k <= length; ++k) {
    ids.push_back(world.add(box(1, vec3(real(0.4)), vec3(k, 0, 0))));
    world.add<HingeJoint>(ids[k - 1], ids[k], vec3(real(k) - real(0.5), 0, 0), vec3(0, 0, 1));
  }
  return world;
}
BodyId body(const World& world, int slot) { return world.bodies.id(slot); }
bool names(const std::string& words, const std::string& what) {
  INFO(words);
  return words.find(what) != std::string::npos;
}
std::string why(const World& world) {
  return refusal([&] { Reduced tree(world); });
}

}  // namespace

TEST_CASE("loops, soft joints and joints without coordinates are refused by number and kind") {
  World loop = chain(3);
  loop.add<BallJoint>(body(loop, 0), body(loop, 3), vec3(2, 1, 0));
  CHECK(names(why(loop), "joint 3 (PartJoint<Point>) closes a loop"));
  CHECK(names(why(loop), "use DirectSolver"));

  World walls = chain(2);  // a chain between two static bodies is a loop through the ground
  const BodyId wall = walls.add(static_body(vec3(3, 0, 0)));
  walls.add<HingeJoint>(body(walls, 2), wall, vec3(real(2.5), 0, 0), vec3(0, 0, 1));
  CHECK(names(why(walls), "joint 2 (HingeJoint) closes a loop"));

  World rods = chain(1);
  rods.add<DistanceJoint>(body(rods, 1), rods.add(box(1, vec3(1), vec3(3, 0, 0))), vec3(1, 0, 0),
                          vec3(3, 0, 0));
  CHECK(names(why(rods), "joint 1 (PartJoint<Distance>) has no reduced coordinates"));

  World soft = chain(2);
  soft.joints()[1]->frequency = 3;
  CHECK(names(why(soft), "joint 1 (HingeJoint) is soft"));

  World cone = chain(1);
  cone.add<ConeTwistJoint>(body(cone, 1), cone.add(box(1, vec3(1), vec3(3, 0, 0))), vec3(2, 0, 0),
                           vec3(1, 0, 0), vec3(0, 1, 0), real(0.5));
  CHECK(names(why(cone), "joint 1 (ConeTwistJoint) has limits"));

  World six = chain(1);
  auto& both = six.add<SixDofJoint>(body(six, 1), six.add(box(1, vec3(1), vec3(3, 0, 0))),
                                    vec3(2, 0, 0), vec3(1, 0, 0), vec3(0, 1, 0));
  both.twist().set_limits(0, 0);  // the swing is left, which is no chain of hinges
  CHECK(names(why(six), "joint 1 (SixDofJoint) has rotations"));
  both.swing2().set_limits(0, 0);
  CHECK(why(six) == "accepted");
}

TEST_CASE("poses that do not satisfy a joint are refused with the gap, unless it is allowed") {
  World world = chain(2);
  world.bodies.at(2).x.y += real(0.01);
  CHECK(names(why(world), "joint 1 (HingeJoint) has an error of 0.010000 m"));
  Reduced tree(world, real(0.02));
  tree.step(world, h);
  CHECK(world.joints()[1]->body1 == body(world, 1));
  CHECK(length(world_point(world.bodies.at(2), vec3(real(-0.5), 0, 0)) -
               world_point(world.bodies.at(1), vec3(real(0.5), 0, 0))) < 8 * epsilon);
  World turned = chain(2);
  turned.bodies.at(2).q = rotation(vec3(0, real(0.01), 0));
  turned.bodies.at(2).x += to_world(turned.bodies.at(2), vec3(real(0.5), 0, 0)) -
                           vec3(real(0.5), 0, 0);
  CHECK(names(why(turned), "joint 1 (HingeJoint) has an error of 0.0"));
  CHECK(names(why(turned), " rad at the present poses"));
}

TEST_CASE("invalid settings of a step in coordinates are refused and change nothing") {
  World world = chain(3);
  Reduced tree(world);
  const std::vector<Body> before = snapshot(world.bodies);
  for (const real bad : {real(0), -h, unbounded})
    CHECK(names(refusal([&] { tree.step(world, bad); }), "h is"));
  tree.iterations = 0;
  CHECK(names(refusal([&] { tree.step(world, h); }), "iterations"));
  tree.iterations = 2;
  static_cast<HingeJoint&>(*world.joints()[0]).set_limits(-1, 1);
  tree.method = Reduced::Method::runge_kutta;
  CHECK(names(refusal([&] { tree.step(world, h); }), "Runge-Kutta"));
  CHECK(same_bodies(world, before));
}

TEST_CASE("a tree follows what is changed between its steps") {
  World world = chain(4);
  Reduced tree(world);
  CHECK(tree.degrees_of_freedom() == 4);
  tree.step(world, h);
  world.remove(*world.joints()[2]);  // the last two fall freely
  tree.step(world, h);
  CHECK(tree.degrees_of_freedom() == 2 + 7);
  CHECK(tree.trees() == 2);
  world.add<BallJoint>(body(world, 4), world.add(box(2, vec3(1), vec3(6, 0, 0))),
                       world.bodies.at(4).x);
  tree.step(world, h);
  CHECK(tree.degrees_of_freedom() == 2 + 7 + 3);
  // a push is taken as far as the joints permit it
  world.bodies.at(1).v += vec3(0, 0, 5);
  world.bodies.at(4).v += vec3(0, 0, 5);
  tree.step(world, h);
  CHECK(std::abs(world.bodies.at(1).v.z) < 64 * epsilon);
  CHECK(world.bodies.at(4).v.z > real(0.1));
  // so is another mass
  world.bodies.at(2).inverse_mass /= 10;
  world.bodies.at(2).inverse_inertia_local /= real(10);
  const auto mine = tree.accelerations(world);
  const auto fresh = Reduced(world).accelerations(world);
  for (std::size_t k = 0; k < mine.size(); ++k) CHECK(length(mine[k].v - fresh[k].v) < 1e-4);
}

TEST_CASE("a body without joints falls, and a kinematic one moves on, as with rows") {
  World world;
  const BodyId stone = world.add(box(3, vec3(1, 2, 3), vec3(0))),
               belt = world.add(static_body(vec3(5, 0, 0)));
  world.bodies[belt].kinematic = true;
  world.bodies[belt].v = vec3(1, 0, 0);
  world.bodies[belt].w = vec3(0, 2, 0);
  world.bodies[stone].force = vec3(3, 0, 0);
  Reduced tree(world);
  for (int k = 0; k < 60; ++k) tree.step(world, h);
  CHECK(length(world.bodies[stone].x - vec3(real(0.5), real(-9.81) / 2, 0)) <
        tolerance(1e-12, 1e-4));
  CHECK(length(world.bodies[belt].x - vec3(6, 0, 0)) < tolerance(1e-12, 1e-4));
  CHECK(std::abs(dot(world.bodies[belt].q, rotation(vec3(0, 2, 0)))) > 1 - tolerance(1e-12, 1e-5));
}

TEST_CASE("steps in coordinates allocate nothing after the first") {
  for (const auto method : {Reduced::Method::leapfrog, Reduced::Method::runge_kutta}) {
    Random random(51006);
    TreeFamily family;
    family.joints = 30;
    family.six = false;
    World world = drawn_tree(random, family);
    Reduced tree(world);
    tree.method = method;
    tree.step(world, h / 10);
    CHECK(allocations_of([&] {
            for (int k = 0; k < 10; ++k) tree.step(world, h / 10);
          }) == 0);
  }
}

TEST_CASE("equal trees, which go on lanes, have the bits of each alone, and allocate nothing") {
  for (const bool floats : {false, true}) {
    const auto add = [&](World& world, int n) {
      std::vector<BodyId> ids;
      for (int k = 0; k < 9; ++k) {
        const vec3 x(real(k), real(n) / 9, real(3 * n)), anchor = x - vec3(real(0.4), 0, 0);
        const bool root = k == 0 && !floats;
        const vec3 size(real(0.4), real(0.5), real(1 + n) / 5);
        ids.push_back(world.add(root ? static_body(x) : box(real(1 + n % 3), size, x)));
        if (!root) world.bodies[ids.back()].w = vec3(real(n), real(k), 1) / real(3);
        if (k == 0) continue;
        const BodyId a = ids[std::size_t(k - 1 - k % 2 * (k > 1))], b = ids.back();
        const vec3 axis = normalize(vec3(real(k % 3), real(n + 1), 1));
        if (k % 4 == 0) world.add<HingeJoint>(a, b, anchor, axis);
        if (k % 4 == 1) world.add<BallJoint>(a, b, anchor);
        if (k % 4 == 2) world.add<SliderJoint>(a, b, anchor, axis);
        if (k % 4 == 3) world.add<FixedJoint>(a, b, anchor);
      }
    };
    const auto move = [](World& world) {
      Reduced tree(world);
      tree.method = Reduced::Method::runge_kutta;
      tree.step(world, h / 4);
      CHECK(allocations_of([&] {
              for (int k = 0; k < 20; ++k) tree.step(world, h / 4);
            }) == 0);
    };
    World together;
    for (int n = 0; n < 11; ++n) add(together, n);
    move(together);
    int same = 0;
    for (int n = 0; n < 11; ++n) {
      World alone;
      add(alone, n);
      move(alone);
      for (int k = 0; k < 9; ++k) {
        const Body &one = alone.bodies.at(k), &two = together.bodies.at(9 * n + k);
        same += one.x == two.x && one.q == two.q && one.v == two.v && one.w == two.w;
      }
    }
    CHECK(same == 99);
  }
}

TEST_CASE("trees have the same bits in any order, and a chain may be of any length") {
  const auto run = [](bool reversed, Reduced::Method method) {
    World world;
    std::vector<std::vector<BodyId>> chains(5);
    for (int n = 0; n < 5; ++n) {
      const int which = reversed ? 4 - n : n;
      auto& ids = chains[std::size_t(which)];
      ids.push_back(world.add(static_body(vec3(0, 0, 3 * which))));
      for (int k = 1; k <= 3 + which; ++k) {
        ids.push_back(world.add(box(1, vec3(real(0.4)), vec3(k, 0, 3 * which))));
        world.add<HingeJoint>(ids[k - 1], ids[k], vec3(real(k) - real(0.5), 0, 3 * which),
                              normalize(vec3(k % 2, which, 1)));
      }
    }
    Reduced tree(world);
    tree.method = method;
    for (int k = 0; k < 30; ++k) tree.step(world, h / 4);
    std::vector<Body> out;
    for (const auto& ids : chains)
      for (const BodyId id : ids) out.push_back(world.bodies[id]);
    return out;
  };
  for (const auto method : {Reduced::Method::leapfrog, Reduced::Method::runge_kutta}) {
    const std::vector<Body> one = run(false, method), other = run(true, method);
    for (std::size_t k = 0; k < one.size(); ++k) {
      CHECK(same_bits(one[k].x, other[k].x));
      CHECK(same_bits(one[k].w, other[k].w));
    }
  }
  World longest = chain(20'000);
  Reduced tree(longest);
  tree.step(longest, h / 100);
  CHECK(tree.degrees_of_freedom() == 20'000);
}
