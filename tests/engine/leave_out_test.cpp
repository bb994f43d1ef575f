// What a scene does not need costs nothing: no row for bodies that cannot move, no linear or
// angular half that is zero, and no memory taken from the heap in a step after the first.
#include "bench/orders.h"
#include "engine/instruments/plan.h"
#include "tests/oracle/allocations.h"
#include "tests/oracle/test.h"

using joints::bench::Order;
using joints::bench::OrderedImpulses;

namespace {

const real h = real(1) / 60;

// Adds its six rows as late limits of every third step only, so that the list of blocks grows where
// nobody expects it.
class Late : public Joint {
 public:
  using Joint::Joint;
  int steps = 0;
  bool added = false;
  mutable Vector<6> impulse{};
  void update_active_rows(const Bodies&, real) override { added = ++steps % 3 != 0; }
  void append(const Bodies&, Blocks&) const override {}
  void activate_missed_limits(const Bodies& bodies, real, Blocks& blocks) override {
    if (added) return;
    added = true;
    Jacobian<6> J;
    Random random(5);
    for (Row& row : J.row) row = random_row(random);
    impulse = {};
    blocks.append(bodies, body1, body2, J, Vector<6>{}, {}, impulse.data());
  }
  Stats stats() const override { return {.limits = 2, .live_limits = 1, .motors = 1}; }
};

// A chain of balls with ropes and rods across it, between two walls that are themselves joined.
struct Net {
  World world;
  std::vector<BodyId> ids;
  Net() {
    for (int k = 0; k < 8; ++k) {
      const vec3 x(real(k), 0, 0);
      ids.push_back(world.add(k == 0 || k == 7 ? static_body(x)
                                               : box(1, vec3(1, real(0.5), real(0.2)), x)));
    }
    const auto at = [&](std::size_t k) -> const Body& { return world.bodies[ids[k]]; };
    for (std::size_t k = 1; k < 6; ++k)
      world.add<BallJoint>(ids[k - 1], ids[k],
                           point_at(at(k - 1), at(k), at(k).x - vec3(real(0.5), 0, 0)));
    world.add<RopeJoint>(ids[0], ids[4], Rope<Distance>{{vec3(0), vec3(0, 1, 0), real(4.1)}});
    world.add<CentreRopeJoint>(ids[7], ids[6], Rope<CentreDistance>{{1}});
    world.add<DistanceJoint>(ids[7], ids[5], Distance{vec3(0, 1, 0), vec3(0), 2});
    world.add<CentreDistanceJoint>(ids[5], ids[6], CentreDistance{1});
    world.add<BallJoint>(ids[0], ids[7], Point{});
  }
};

}  // namespace

TEST_CASE("once all its blocks have been live a world takes no memory in a step") {
  CHECK(allocations_of([] { ::operator delete(::operator new(8)); }) == 1);  // the count works
  for (bool warm : {false, true})
    for (bool row_by_row : {false, true})
      for (Order order : {Order::forward, Order::backward, Order::alternating, Order::shuffled}) {
        Net net;
        net.world.add<Late>(net.ids[1], net.ids[5]);
        OrderedImpulses solver;
        StepOptions stepping;
        solver.iterations = 3;
        stepping.warm_start = warm;
        stepping.row_by_row = row_by_row;
        solver.order = order;
        for (int n = 0; n < 3; ++n) step(net.world, solver, h, stepping);  // late rows in the third
        for (int n = 0; n < 20; ++n)
          CHECK(allocations_of([&] { step(net.world, solver, h, stepping); }) == 0);
        net.world.remove(*net.world.joints()[3]);  // less to do needs no memory either
        net.world.remove(net.ids[6]);
        for (int n = 0; n < 20; ++n)
          CHECK(allocations_of([&] { step(net.world, solver, h, stepping); }) == 0);
        CHECK(finite(net.world.bodies[net.ids[5]].x));
      }
}

TEST_CASE("a rod between centres leaves angular velocities alone") {
  Net net;
  OrderedImpulses solver;
  begin_step(net.world, solver, h);
  REQUIRE(net.world.blocks.list.size() == 9);
  // to the last bit
  net.world.bodies[net.ids[6]].w = vec3(real(0.1), real(0.2), real(0.3));
  for (int k = 0; k < 10; ++k) solver.iterate(net.world.bodies);
  CHECK(net.world.bodies[net.ids[6]].w == vec3(real(0.1), real(0.2), real(0.3)));
}

TEST_CASE("a joint between two static bodies appends nothing") {
  World world;
  const BodyId a = world.add(static_body(vec3(0))), b = world.add(static_body(vec3(1, 0, 0)));
  Blocks blocks;
  BallJoint(a, b, Point{}).append(world.bodies, blocks);
  DistanceJoint(a, b, Distance{}).append(world.bodies, blocks);
  CentreRopeJoint(a, b, {}).append(world.bodies, blocks);
  CHECK(blocks.list.empty());
  CHECK(blocks.rows() == 0);
  CHECK(blocks.C.empty());
}

TEST_CASE("the plan of a step is one line") {
  Net net;
  CHECK(plan(net.world, false).line() ==
        "bodies 8 (2 static), blocks 9, rows 19");
  net.world.add<Late>(net.ids[1], net.ids[5]);
  net.world.remove(net.ids[6]);  // and with it a rope and a rod
  CHECK(plan(net.world, true).line() ==
        "bodies 7 (2 static), blocks 7, rows 17, limits 1 of 2, motors 1, warm");
  CHECK(plan(World(), false).line() ==
        "bodies 0 (0 static), blocks 0, rows 0");
}
