// What a step in coordinates says of itself: nothing where it can follow the motion, and a sentence
// where it cannot, at the latest when energy has grown.
#include <memory>
#include <set>

#include "bench/families.h"
#include "engine/instruments/measure.h"
#include "reduced/reduced.h"
#include "tests/oracle/rigs.h"
#include "tests/oracle/test.h"

namespace {

constexpr auto leapfrog = Reduced::Method::leapfrog, kutta = Reduced::Method::runge_kutta;

// Steps of a world, and whether one of them has said something or given up.
struct Watched {
  Reduced::Method method;
  bool refused = true, said = false;
  std::unique_ptr<Reduced> tree{};
  void step(World& world, real h) {
    if (!tree) {
      tree = std::make_unique<Reduced>(world);
      tree->method = method;
    }
    try {
      tree->step(world, h);
    } catch (const std::invalid_argument&) {
      said = !refused;
      throw;
    } catch (...) {
      refused = false, said = true;
      throw;
    }
    refused = false;
    said = said || !tree->report().sentences().empty();
  }
};

}  // namespace

TEST_CASE("in drawn families a step says what it cannot follow, and nothing where it follows all",
          "[slow]") {
  const std::set<std::string> calm{"hubs", "driven arms", "rotors", "motors in flight"};
  int followed = 0, lost = 0;
  for (const auto& families : {bench::joint_families(), bench::motion_families()})
    for (const bench::Family& family : families)
      for (const auto method : {leapfrog, kutta})
        for (unsigned seed = 0; seed < 6; ++seed) {
          Watched run{method};
          const auto step = [&](World& world, real h) { run.step(world, h); };
          const bench::Outcome out = bench::run_drawn(family.draw(seed), step, false);
          if (run.refused) continue;  // no tree, or Runge-Kutta with limits
          INFO(family.name << ", seed " << seed << ", gain " << out.gain);
          if (calm.contains(family.name)) CHECK_FALSE(run.said);
          followed += !run.said;
          if (out.finite && out.gain < tolerance(0.5, 1)) continue;
          ++lost;
          CHECK(run.said);
        }
  INFO(followed << " silent, " << lost << " lost");
  CHECK(followed > 60);
  CHECK(lost > 20);
}

TEST_CASE("ends of 1e2 to 1e6 links: the step says where their tension is too fast for it",
          "[slow]") {
  int silent = 0, said = 0;
  for (const auto method : {leapfrog, kutta})
    for (int exponent = 2; exponent <= 6; ++exponent)
      for (const int rate : {30, 60, 240, 960}) {
        bench::BenchScene scene = bench::heavy_end_unreferenced(std::pow(10, exponent));
        World& world = scene.world;
        const double before = energy(all_of(world.bodies), world.gravity);
        Watched run{method};
        double gain = 0;
        try {
          for (int k = 0; k < 2 * rate && !run.said; ++k) {
            run.step(world, real(1) / real(rate));
            const double now = energy(all_of(world.bodies), world.gravity);
            gain = std::max(gain, (now - before) / scene.energy_scale);
          }
        } catch (const std::runtime_error&) {
        }
        INFO("1e" << exponent << " at " << rate << " Hz, gain " << gain);
        if (!run.said) CHECK(gain < 0.1);
        if (exponent == 2 && rate == 960) CHECK_FALSE(run.said);
        (run.said ? said : silent) += 1;
      }
  INFO(silent << " silent, " << said << " said");
  CHECK(silent > 10);
  CHECK(said > 5);
}

TEST_CASE("a spring too stiff for Runge-Kutta is said at once, and a soft one is not") {
  for (const real per_step : {real(0.3), real(3.5)}) {
    Rotor rotor(0, 1);  // 1 kg m^2
    const real h = real(1) / 60, rate = per_step / h;
    rotor.hinge->set_spring({.stiffness = rate * rate});
    Watched run{kutta};
    for (int k = 0; k < 10; ++k) run.step(rotor.world, h);
    CHECK(run.said == (per_step > 3));
  }
}

TEST_CASE("a wheel on a free car: up to 100 rad a step, energy is kept or the step says it") {
  for (const auto method : {leapfrog, kutta})
    for (const double turn : {0.5, 2.5, 5.0, 10.0, 30.0, 100.0}) {
      World car;
      car.gravity = vec3(0);
      const BodyId body = car.add(box(1000, vec3(4, real(1.2), real(1.8)), vec3(0)));
      const vec3 hub(real(1.5), 0, 1);
      const BodyId wheel = car.add(body_with(20, vec3(real(0.5), real(0.5), real(0.9)), hub));
      car.add<HingeJoint>(body, wheel, hub, vec3(0, 0, 1));
      car.bodies[wheel].w = vec3(0, 0, real(60 * turn));
      car.bodies[body].w = vec3(real(0.3), real(0.5), real(0.2));
      Watched run{method};
      Reduced(car).satisfy(car);
      const double before = energy(all_of(car.bodies), car.gravity);
      try {
        for (int k = 0; k < 300 && !run.said; ++k) run.step(car, real(1) / 60);
      } catch (const std::runtime_error&) {
      }
      INFO(turn << " rad a step");
      if (!run.said) CHECK(energy(all_of(car.bodies), car.gravity) == Approx(before).epsilon(0.01));
      if (turn <= 2.5) CHECK_FALSE(run.said);
    }
}
