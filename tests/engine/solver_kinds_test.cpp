// Solvers behind one interface: chosen at run time they find the same impulses, and input that
// would break them silently is rejected.
#include "bench/orders.h"
#include "engine/simd/packed.h"
#include "library/examples/symmetric_impulses.h"
#include "tests/oracle/beside.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

// Boxes on hinges and balls that branch, one hinge with a motor, one at its limit.
World machine() {
  World world;
  Random random(141);
  std::vector<BodyId> ids{world.add(static_body(vec3(0)))};
  for (int k = 1; k <= 6; ++k) {
    const BodyId before = ids[std::size_t(k < 4 ? k - 1 : k - 3)];
    const vec3 x = world.bodies[before].x + vec3(real(0.8), 0, k < 4 ? real(0) : real(0.6));
    ids.push_back(world.add(box(random.uniform(1, 3), vec3(real(0.7), real(0.3), real(0.4)), x)));
    const vec3 anchor = (x + world.bodies[before].x) / real(2);
    if (k % 2 == 0) {
      world.add<BallJoint>(before, ids.back(), point_at(world.bodies[before],
                                                        world.bodies[ids.back()], anchor));
      continue;
    }
    auto& hinge = world.add<HingeJoint>(before, ids.back(), anchor, vec3(0, 1, 1));
    if (k == 3) hinge.set_motor(2, 5);
    if (k == 5) hinge.set_limits(0, 1);
  }
  push_at_random(world.bodies, random, 1);
  return world;
}

std::vector<std::pair<std::string, std::unique_ptr<IterativeSolver>>> kinds() {
  std::vector<std::pair<std::string, std::unique_ptr<IterativeSolver>>> out;
  const auto add = [&](const std::string& name, auto solver) {
    solver.iterations = 3000;
    out.push_back({name, std::make_unique<decltype(solver)>(solver)});
  };
  bench::OrderedImpulses backward;
  backward.order = bench::Order::backward;
  PackedImpulses scalar, colours;
  scalar.packing = Packing::interleaved;
  colours.packing = Packing::colours;
  add("blocks", SequentialImpulses());
  add("row by row", SequentialImpulses());
  add("backward", backward);
  add("packed", scalar);
  add("lanes", PackedImpulses());
  add("lanes in colours", colours);
  add("one's own", SymmetricImpulses());
  return out;
}

}  // namespace

TEST_CASE("every kind of solver finds the same impulses in the same world") {
  const auto solvers = kinds();
  Column first;
  for (const auto& [name, solver] : solvers) {
    CAPTURE(name);
    World world = machine();
    step(world, *solver, h, {.row_by_row = name == "row by row"});
    const Column found = impulses(world.blocks);
    if (first.size() == 0) first = found;
    REQUIRE(found.size() == first.size());
    CHECK(found.norm() > 1);
    CHECK(difference(found, first) < tolerance(1e-9, 1e-4) * first.largest());
  }
  CHECK(first.size() == 5 * 3 + 3 * 3 + 1 + 1);  // hinges, balls, a motor, a limit
}

TEST_CASE("a world may be handed from solver to solver between its steps") {
  World world = machine(), alone = machine();
  const auto solvers = kinds();
  SequentialImpulses one;
  one.iterations = 3000;
  for (std::size_t n = 0; n < solvers.size(); ++n) {
    step(world, *solvers[n].second, h,
         {.warm_start = true, .row_by_row = solvers[n].first == "row by row"});
    step(alone, one, h, {.warm_start = true});
  }
  CHECK(speeds_apart(world, alone) < tolerance(1e-7, 1e-2));
}

TEST_CASE("a solver that was prepared for one world refuses the bodies of another") {
  World world = machine(), other = machine();
  SequentialImpulses solver;
  begin_step(world, solver, h);
  CHECK_THROWS_AS(solver.iterate(other.bodies), std::logic_error);
  CHECK_THROWS_AS(solver.solve(other.bodies), std::logic_error);
  CHECK_THROWS_AS(solver.warm_start(other.bodies, 1), std::logic_error);
  CHECK_NOTHROW(solver.iterate(world.bodies));
  PackedImpulses packed;
  begin_step(world, packed, h);
  CHECK_THROWS_AS(packed.solve(other.bodies), std::logic_error);
  CHECK_THROWS_AS(packed.warm_start(other.bodies, 1), std::logic_error);
}

TEST_CASE("blocks that came after the preparation are refused, not left out") {
  World world = machine();
  SequentialImpulses solver;
  begin_step(world, solver, h);
  world.joints().front()->append(world.bodies, world.blocks);
  CHECK_THROWS_AS(solver.solve(world.bodies), std::logic_error);
  solver.prepare(world.bodies, world.blocks, solver.prepared_count(), h);
  CHECK_NOTHROW(solver.solve(world.bodies));
  for (int n = 0; n < 2; ++n) world.joints().front()->append(world.bodies, world.blocks);
  const int last = int(world.blocks.list.size()) - 1;
  solver.prepare(world.bodies, world.blocks, last, h);  // leaves one out
  CHECK_THROWS_AS(solver.solve(world.bodies), std::logic_error);
}

TEST_CASE("a range of blocks is one of those that were prepared, rows apart or not") {
  for (const bool row_by_row : {false, true}) {
    World world = machine();
    SequentialImpulses solver;
    begin_step(world, solver, h, {.row_by_row = row_by_row});
    const int count = row_by_row ? world.blocks.rows() : int(world.blocks.list.size());
    CHECK(solver.prepared_count() == count);
    CHECK_NOTHROW(solver.iterate(world.bodies, 0, count));
    CHECK_THROWS_AS(solver.iterate(world.bodies, 0, count + 1), std::invalid_argument);
    CHECK_THROWS_AS(solver.iterate(world.bodies, -1, count), std::invalid_argument);
  }
}

TEST_CASE("substeps are shorter steps, and leapfrog begins with half a kick") {
  World in_one = machine(), by_hand = machine();
  SequentialImpulses one, other;
  step(in_one, one, h, {.substeps = 4, .leapfrog = true});
  step(in_one, one, h, {.substeps = 4, .leapfrog = true});
  for (int n = 0; n < 8; ++n) step(by_hand, other, h / 4, {.leapfrog = true});
  CHECK(speeds_apart(in_one, by_hand) == 0);

  World free_fall;
  const BodyId id = free_fall.add(box(1, vec3(1), vec3(0)));
  step(free_fall, one, h, {.leapfrog = true});
  CHECK(double(free_fall.bodies[id].v.y) == Approx(-9.81 / 120));
  step(free_fall, one, h, {.leapfrog = true});
  CHECK(double(free_fall.bodies[id].v.y) == Approx(-9.81 * 3 / 120));
  step(free_fall, one, h / 3, {.leapfrog = true});  // the mean of h and h/3
  CHECK(double(free_fall.bodies[id].v.y) == Approx(-9.81 * (3 + 4.0 / 3) / 120));
}

TEST_CASE("a soft step is the step of blocks that are soft themselves, motors left as they are") {
  World by_step = machine(), by_hand = machine();
  SequentialImpulses one, other;
  step(by_step, one, h, {.frequency = 8, .damping = 2});
  begin_step(by_hand, other, h);
  int soft = 0;
  for (Block& block : by_hand.blocks.list)
    if (RowSettings& row = block.settings; row.holds_position)
      row.frequency = 8, row.damping = 2, ++soft;
  other.prepare(by_hand.bodies, by_hand.blocks, 0, h);
  other.solve(by_hand.bodies);
  end_step(by_hand, other, h);
  CHECK(soft == int(by_hand.blocks.list.size()) - 1);
  CHECK(speeds_apart(by_step, by_hand) == 0);
  World hard = machine();
  step_once(hard, h);
  CHECK(speeds_apart(by_step, hard) > 1e-4);
}
