// The direct solver from step to step: memory, bits, worlds that change, substeps, steps of any
// length.
#include "tests/direct/rigs.h"
#include "tests/oracle/allocations.h"
#include "tests/oracle/beside.h"
#include "tests/oracle/test.h"

using namespace joints::chapter9;

namespace {

const real h = sixtieth;

// A net, loops and all, with a motor and a limit at one of its corners.
World machine() {
  Scene scene = net(4);
  const BodyId corner = scene.world.bodies.id(15);
  const BodyId arm = scene.world.add(body_with(1, vec3(real(0.1)), vec3(4, 0, 3)));
  HingeJoint& hinge =
      on_hinge(scene, corner, arm, vec3(real(3.5), 0, 3), vec3(0, real(0.2), 1));
  hinge.set_motor(2, 3);
  hinge.set_limits(-1, real(0.3));
  return std::move(scene.world);
}

void run(World& world, Solver& solver, int steps, real length = h) {
  for (int n = 0; n < steps; ++n) step(world, solver, length, second_order);
}

}  // namespace

TEST_CASE("a step of the direct solver takes no memory once its vectors have grown") {
  for (const int newton : {0, 8})
    for (const real added_inertia : {real(0), real(16)}) {
      CAPTURE(newton, added_inertia);
      Scene scene = net(5);
      DirectSolver solver = with(newton, added_inertia);
      run(scene.world, solver, 60);
      CHECK(allocations_of([&] { run(scene.world, solver, 20); }) == 0);
      Scene other = net(4);
      CHECK(allocations_of([&] { run(other.world, solver, 1); }) > 0);  // a new pattern
    }
}

TEST_CASE("the direct solver gives the same bits twice") {
  for (const int newton : {0, 8}) {
    World one = machine(), other = machine();
    DirectSolver first = with(newton), second = with(newton);
    run(one, first, 100);
    run(other, second, 100);
    CHECK(same_bodies(one, other));
    run(other, second, 1);
    CHECK_FALSE(same_bodies(one, other));
  }
}

TEST_CASE("what one solver finds depends on nothing of the steps before") {
  // joints and bodies come and go, and a fresh solver has each step to itself
  World kept = machine(), fresh = machine();
  DirectSolver solver;
  Random one(931), other(931);
  const auto change = [](World& world, Random& random, int n) {
    if (n % 7 == 3) {
      const BodyId id = world.add(box(2, vec3(real(0.3)), random.vector(3)));
      const BodyId corner = world.bodies.id(15);
      world.add<BallJoint>(corner, id,
                           point_at(world.bodies[corner], world.bodies[id], random.vector(3)))
          .beta = 1;
    }
    if (n % 7 == 6) world.remove(*world.joints()[std::size_t(n) % world.joints().size()]);
    if (n % 14 == 13) world.remove(world.bodies.id(1 + n / 14));
  };
  for (int n = 0; n < 40; ++n) {
    change(kept, one, n);
    change(fresh, other, n);
    step(kept, solver, h, second_order);
    DirectSolver new_one;
    step(fresh, new_one, h, second_order);
    REQUIRE(same_bodies(kept, fresh));
  }
}

TEST_CASE("one solver serves two worlds in turn") {
  for (const int newton : {0, 8}) {
    Scene chain = heavy_chain(8, 10), longer = heavy_chain(12, 1), chain_alone = heavy_chain(8, 10),
          longer_alone = heavy_chain(12, 1);
    DirectSolver both = with(newton), one = with(newton), other = with(newton);
    for (int n = 0; n < 60; ++n) {
      run(chain.world, both, 1);
      run(longer.world, both, 1);
    }
    run(chain_alone.world, one, 60);
    run(longer_alone.world, other, 60);
    CHECK(same_bodies(chain.world, chain_alone.world));
    CHECK(same_bodies(longer.world, longer_alone.world));
  }
}

TEST_CASE("Newton's method may be switched off, and nothing of it is left") {
  Scene scene = heavy_chain(8, 10);
  DirectSolver solver = shake(), fresh = with(0);
  run(scene.world, solver, 30);
  solver.newton = 0;
  run(scene.world, solver, 1);
  Scene other = heavy_chain(8, 10);
  for (int slot = 0; slot < other.world.bodies.slots(); ++slot)
    other.world.bodies.at(slot) = scene.world.bodies.at(slot);
  other.world.last_h = scene.world.last_h;
  run(scene.world, solver, 1);
  run(other.world, fresh, 1);
  CHECK(same_bodies(scene.world, other.world));
}

TEST_CASE("substeps are shorter steps for the direct solver, too") {
  for (const int newton : {0, 8}) {
    World in_one = machine(), by_hand = machine();
    DirectSolver one = with(newton), other = with(newton);
    for (int n = 0; n < 20; ++n) {
      step(in_one, one, h, {.substeps = 4, .leapfrog = true});
      run(by_hand, other, 4, h / 4);
    }
    CHECK(same_bodies(in_one, by_hand));
  }
}

TEST_CASE("steps whose length changes keep a chain together, and its energy") {
  Scene scene = heavy_chain(10, 10);
  DirectSolver solver = shake();
  const double start = energy(all_of(scene.world.bodies), scene.world.gravity);
  GapMeter meter;
  for (int n = 0; n < 600; ++n) {
    run(scene.world, solver, 1, real(n % 2 == 0 ? 1 : 3) / 480);
    meter.look(scene.marks, poses(scene.world.bodies));
  }
  CHECK(meter.maximum() < tolerance(1e-6, 1e-3));
  const double change = energy(all_of(scene.world.bodies), scene.world.gravity) - start;
  CHECK(std::abs(change) < 0.05 * scene.energy_scale);
}

TEST_CASE("warm starting changes nothing that the direct solver finds") {
  World warm = machine(), cold = machine();
  DirectSolver one = DirectSolver::velocities_only(), other = one;
  for (int n = 0; n < 30; ++n) {
    step(warm, one, h, {.warm_start = true, .leapfrog = true});
    step(cold, other, h, second_order);
  }
  CHECK(apart(warm, cold) < tolerance(1e-4, 0.05));  // loops are softened
}
