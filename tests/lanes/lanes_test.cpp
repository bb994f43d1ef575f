// The solver on lanes: the same rows, the same numbers.
#include <numeric>
#include <random>

#include "bench/scenes.h"
#include "engine/simd/packed.h"
#include "tests/oracle/beside.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

// Joints of every kind between bodies that are thrown about, in the order that is given.
World zoo(const std::vector<int>& order) {
  World world;
  std::vector<BodyId> ids;
  for (int k = 0; k < 16; ++k) {
    const vec3 x(real(k % 4), real(k / 4), real(0.1) * real(k % 3));
    Body body = box(real(1 + k % 5), vec3(real(0.5), real(0.3), real(0.2)), x,
                    normalize(quat(1, real(0.1) * real(k), real(0.2), 0)));
    body.v = vec3(real(k % 3) - 1, real(k % 2), 0);
    body.w = vec3(0, real(k % 4) - real(1.5), 1);
    ids.push_back(k == 0 ? world.add(static_body(x)) : world.add(body));
  }
  Bodies& bodies = world.bodies;
  for (const int k : order) {
    const BodyId a = ids[std::size_t(k % 15)], b = ids[std::size_t(k % 15 + 1)];
    const vec3 anchor = (bodies[a].x + bodies[b].x) / real(2);
    switch (k % 6) {
      case 0: world.add<BallJoint>(a, b, point_at(bodies[a], bodies[b], anchor)); break;
      case 1: world.add<FixedJoint>(a, b, anchor); break;
      case 2: world.add<HingeJoint>(a, b, anchor, vec3(1, 2, 3)); break;
      case 3: world.add<DistanceJoint>(a, b, Distance{vec3(0), vec3(0), 1}); break;
      case 4: world.add<SliderJoint>(a, b, anchor, vec3(1, 0, 1)); break;
      case 5:
        world.add<HingeJoint>(a, b, anchor, vec3(0, 0, 1))
            .set_limits(real(0.02), 3);  // passed from the beginning: a row of the block
        break;
    }
  }
  return world;
}

}  // namespace

TEST_CASE("one island per lane keeps its own order: chains move as with the scalar solver") {
  for (const bool warm : {false, true}) {
    bench::BenchScene scalar = bench::cubes_on_hinges(10, 12);
    bench::BenchScene wide = bench::cubes_on_hinges(10, 12);
    SequentialImpulses one;
    PackedImpulses other;
    StepOptions stepping{.warm_start = warm};
    stepping.projections = 1;
    for (int n = 0; n < 60; ++n) {
      step(scalar.world, one, h, stepping);
      step(wide.world, other, h, stepping);
    }
    CHECK(apart(scalar.world, wide.world) < tolerance(1e-11, 1e-3));
    CHECK(other.packed().order().groups() == 11 * ((10 + lane_count - 1) / lane_count));
  }
}

TEST_CASE("on lanes in colours the numbers are those of the scalar solver in that order") {
  std::vector<int> order(15);
  std::iota(order.begin(), order.end(), 0);
  PackedImpulses wide;
  wide.packing = Packing::colours;
  World first = zoo(order);
  step(first, wide, h);
  std::vector<int> coloured;  // of the joints: here each has one block
  for (const int block : wide.packed().order().blocks)
    if (block >= 0) coloured.push_back(block);
  REQUIRE(coloured.size() == 15);

  World on_lanes = zoo(order), in_order = zoo(coloured);
  PackedImpulses lanes;
  lanes.packing = Packing::colours;
  SequentialImpulses scalar;
  for (int n = 0; n < 10; ++n) {
    step(on_lanes, lanes, h);
    step(in_order, scalar, h);
  }
  CHECK(apart(on_lanes, in_order) < tolerance(1e-11, 1e-3));
}

TEST_CASE("in a group of lanes no two blocks share a body that moves") {
  std::vector<int> order(30);
  std::iota(order.begin(), order.end(), 0);
  World world = zoo(order);
  PackedImpulses wide;
  wide.packing = Packing::colours;
  step(world, wide, h);
  int blocks = 0;
  const LaneOrder& order_found = wide.packed().order();
  REQUIRE(order_found.width == lane_count);
  for (std::size_t group = 0; group < std::size_t(order_found.groups()); ++group) {
    std::vector<int> seen;
    for (int lane = 0; lane < lane_count; ++lane) {
      if (order_found.blocks[group * lane_count + std::size_t(lane)] < 0) continue;
      ++blocks;
      const auto end = [&](bool second) {
        return order_found.ends[(2 * group + second) * lane_count + std::size_t(lane)];
      };
      for (const int body : {end(false), end(true)})
        if (body < world.bodies.slots())  // behind them: zeros for those that do not move
          seen.push_back(body);
      if (end(false) == end(true)) seen.pop_back();  // a row of one body
    }
    std::sort(seen.begin(), seen.end());
    CHECK(std::adjacent_find(seen.begin(), seen.end()) == seen.end());
  }
  CHECK(blocks >= 30);
}

TEST_CASE("on lanes momentum is kept and a static body stays to the last bit") {
  std::vector<int> order(14);
  std::iota(order.begin(), order.end(), 1);  // without the static body's joint
  World world = zoo(order);
  world.gravity = vec3(0);
  const auto momentum = [&] {
    vec3 sum(0);
    for (int slot = 1; slot < world.bodies.slots(); ++slot)
      sum += world.bodies.at(slot).v / world.bodies.at(slot).inverse_mass;
    return sum;
  };
  const vec3 before = momentum();
  for (const Packing packing : {Packing::automatic, Packing::colours}) {
    PackedImpulses wide;
    wide.packing = packing;
    for (int n = 0; n < 20; ++n) step(world, wide, h);
  }
  CHECK(double(length(momentum() - before)) < tolerance(1e-11, 1e-3));
  CHECK(world.bodies.at(0).x == vec3(0));
  CHECK(world.bodies.at(0).v == vec3(0));
}

TEST_CASE("what overflows in one joint does not reach another through a static body") {
  const auto check = [](auto solver) {
    World world;
    const BodyId wall = world.add(static_body(vec3(0)));
    std::vector<BodyId> ids;
    for (int k = 0; k < 2 * lane_count; ++k) {
      ids.push_back(world.add(ball(1, real(0.1), vec3(1, real(k), 0))));
      const vec3 at(0, real(k), 0), to_wall(-1, 0, 0);
      if (k % 2 == 0) world.add<BallJoint>(wall, ids.back(), Point{at, to_wall});
      else world.add<BallJoint>(ids.back(), wall, Point{to_wall, at});
    }
    const real huge = std::numeric_limits<real>::max();
    for (const int k : {0, 1}) world.bodies[ids[k]].v = world.bodies[ids[k]].w = vec3(huge);
    begin_step(world, solver, h);
    solver.solve(world.bodies);
    for (const int k : {0, 1})
      CHECK_FALSE((finite(world.bodies[ids[k]].v) && finite(world.bodies[ids[k]].w)));
    for (std::size_t k = 2; k < ids.size(); ++k)
      CHECK((finite(world.bodies[ids[k]].v) && finite(world.bodies[ids[k]].w)));
    CHECK((world.bodies[wall].v == vec3(0) && world.bodies[wall].w == vec3(0)));
  };
  check(SequentialImpulses());
  for (const Packing packing : {Packing::automatic, Packing::colours, Packing::list}) {
    PackedImpulses wide;
    wide.packing = packing;
    check(wide);
  }
}

TEST_CASE("the packing is chosen by how many lanes it would use, and is said in words") {
  const std::string lanes = std::to_string(lane_count) + " lanes, ";
  const auto words = [](const World& world, PackedImpulses solver) {
    Blocks blocks;
    for (const auto& joint : world.joints()) joint->append(world.bodies, blocks);
    return solver.description(world.bodies, blocks);
  };
  const auto pendulums = [](int islands, int length) {
    World world;
    for (int k = 0; k < islands; ++k) {
      BodyId before = world.add(static_body(vec3(0, 0, real(k))));
      for (int n = 1; n <= length; ++n) {
        const BodyId next = world.add(ball(1, real(0.1), vec3(real(n), 0, real(k))));
        world.add<BallJoint>(before, next, Point{vec3(real(0.5), 0, 0), vec3(real(-0.5), 0, 0)});
        before = next;
      }
    }
    return world;
  };
  CHECK(words(pendulums(lane_count, 3), {}) == lanes + "an island in each");
  CHECK(words(pendulums(1, 4 * lane_count), {}) == lanes + "by colours");
  CHECK(words(pendulums(1, 2), {}) == "one block at a time");
  PackedImpulses list;
  list.packing = Packing::list;
  CHECK(words(pendulums(lane_count, 3), list) == "one block at a time");
  CHECK(SequentialImpulses().description(World().bodies, Blocks()).empty());
}

TEST_CASE(
    "on lanes a limit that a neighbour drives a joint past is found late") {
  for (const bool lanes : {true, false}) {
    World world = weightless();
    const BodyId wall = world.add(static_body(vec3(0)));
    const BodyId rotor = world.add(body_with(1, vec3(1), vec3(0)));
    const BodyId stone = world.add(ball(real(0.1), real(0.1), vec3(1, 0, 0)));
    auto& hinge = world.add<HingeJoint>(wall, rotor, vec3(0), vec3(0, 0, 1));
    hinge.set_limits(real(-0.1), real(0.1));
    world.add<BallJoint>(rotor, stone,
                         point_at(world.bodies[rotor], world.bodies[stone], vec3(1, 0, 0)));
    world.bodies[stone].v = vec3(0, 100, 0);
    SequentialImpulses scalar;
    PackedImpulses wide;
    scalar.iterations = wide.iterations = 100;
    lanes ? step(world, wide, h) : step(world, scalar, h);
    CHECK(double(hinge.position(world.bodies)) == Approx(0.1).margin(tolerance(1e-6, 1e-4)));
  }
}
