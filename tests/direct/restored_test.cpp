// Worlds that are saved and restored: they go on to the bit, with every kind of mechanism.
#include "bench/families.h"
#include "engine/kept/state.h"
#include "tests/direct/rigs.h"
#include "tests/oracle/test.h"

namespace {

// True if a world goes on as one that was built anew and restored, with a solver of its own.
bool goes_on(World& world, World& other, DirectSolver solver, const StepOptions& how, int steps) {
  for (int n = 0; n < steps; ++n) step(world, solver, sixtieth, how);
  DirectSolver fresh = with(solver.newton, solver.added_inertia);  // it has solved nothing yet
  restore(other, save(world));
  for (int n = 0; n < 40; ++n) {
    step(world, solver, sixtieth, how);
    step(other, fresh, sixtieth, how);
    if (!(save(world) == save(other))) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("every family of mechanisms goes on to the bit after it was restored") {
  for (const bench::Family& family : bench::joint_families())
    for (const unsigned seed : {1u, 2u})
      for (const real added : {real(0), real(8)}) {
        CAPTURE(family.name, seed, double(added));
        bench::Drawn one = family.draw(seed), other = family.draw(seed);
        CHECK(goes_on(one.world, other.world, with(8, added), second_order, 60));
      }
}

TEST_CASE("mechanisms of all joints, with loops or without, go on to the bit after a restoration") {
  for (unsigned seed = 1; seed <= 8; ++seed)
    for (const bool warm : {false, true}) {
      CAPTURE(seed, warm);
      const auto made = [&] {
        Random random(seed);
        World world = mechanism(random, 6 + int(seed), int(seed % 3));
        feed_back_all(world);
        return world;
      };
      World one = made(), other = made();
      CHECK(goes_on(one, other, with(8), {.warm_start = warm, .leapfrog = !warm}, 60));
    }
}
