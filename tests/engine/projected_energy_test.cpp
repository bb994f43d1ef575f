// Position projection and energy, in linkages that are drawn.
#include "bench/families.h"
#include "engine/sequential_impulses.h"
#include "tests/oracle/test.h"

namespace {

// The largest gain of energy in ten seconds from a cold start without feedback [energy_scale].
double gain(bench::Drawn scene, int projections) {
  World& world = scene.world;
  world.set_beta(0);
  SequentialImpulses solver;
  solver.iterations = 30;
  const auto now = [&] { return energy(all_of(world.bodies), world.gravity); };
  const double start = now();
  double most = 0;
  for (int n = 0; n < 600; ++n) {
    step(world, solver, real(1) / 60, {.projections = projections});
    most = std::max(most, now() - start);
  }
  return most / scene.energy_scale;
}

}  // namespace

// The counts stand with project_positions().
TEST_CASE("projection adds energy to some linkages whose rows depend on others, to no others",
          "[slow]") {
  int gained = 0, others = 0, without = 0;
  double worst = 0;
  for (const bench::Family& family : bench::joint_families()) {
    const bool dependent = family.name == "Bricard";
    if (!dependent && family.name != "unequal four-bars" && family.name != "slider-cranks" &&
        family.name != "loose rings")
      continue;
    const unsigned draws = dependent ? 80 : 20;
    for (unsigned seed = 71001; seed < 71001 + draws; ++seed) {
      const double one = gain(family.draw(seed), 4);
      (dependent ? gained : others) += one > 0.01;
      worst = std::max(worst, one);
      without += dependent && gain(family.draw(seed), 0) > 0.01;
    }
  }
  CAPTURE(gained, worst, others, without);
  CHECK(others == 0);
  CHECK(without == 0);
  CHECK(gained >= 5);
  CHECK(gained <= 13);
  CHECK(worst > 0.3);
  CHECK(worst < 0.9);
}
