// Machines put together at random: whatever hinges, sliders and welds are hung on each other and
// however they are thrown, they stay finite, inside their limits, and gain no energy.
#include "engine/instruments/measure.h"
#include "tests/oracle/test.h"

namespace {

const real h = real(1) / 60;

// Three uneven bodies in a row on a wall, each on a joint of a kind that is drawn.
struct Machine {
  World world;
  std::vector<HingeJoint*> hinges;
  std::vector<SliderJoint*> sliders;

  Machine(unsigned seed, bool whole) {
    Random random(seed);
    if (seed % 2 == 0) world.gravity = vec3(0);
    BodyId last = world.add(static_body(vec3(0)));
    for (int k = 0; k < 3; ++k) {
      const real mass = random.uniform(real(0.5), 2);
      const vec3 moments = vec3(real(0.75)) + random.vector(real(0.15));
      const vec3 x = vec3(real(k + 1), 0, 0) + random.vector(real(0.3));
      const BodyId next = world.add(body_with(mass, moments, x, random.turn()));
      const vec3 anchor = vec3(real(k) + real(0.5), 0, 0) + random.vector(real(0.2));
      const vec3 axis = random.vector(1) + vec3(real(0.1), 0, 0);
      const real lower = -random.uniform(0, 1), upper = random.uniform(0, 1);
      const int kind = int(random.uniform(0, 3));
      if (kind == 0) {
        hinges.push_back(&world.add<HingeJoint>(last, next, anchor, axis));
        hinges.back()->whole = whole;
        hinges.back()->set_limits(lower, upper);
      } else if (kind == 1) {
        sliders.push_back(&world.add<SliderJoint>(last, next, anchor, axis));
        sliders.back()->whole = whole;
        sliders.back()->set_limits(lower, upper);
      } else {
        world.add<FixedJoint>(last, next, anchor).whole = whole;
      }
      last = next;
    }
    push_at_random(world.bodies, random, 10);
  }
  double energy() const { return joints::energy(all_of(world.bodies), world.gravity); }
  // How far a joint is beyond its limits [rad or m].
  double beyond() const {
    double worst = 0;
    const auto look = [&](const auto& joint) {
      const real x = joint->position(world.bodies);
      worst = std::max({worst, double(x - joint->limits().upper),
                        double(joint->limits().lower - x)});
    };
    for (const HingeJoint* joint : hinges) look(joint);
    for (const SliderJoint* joint : sliders) look(joint);
    return worst;
  }
};

}  // namespace

TEST_CASE("random machines of hinges and sliders and welds keep their limits and gain no energy") {
  for (bool whole : {true, false})
    for (bool warm : {false, true})
      for (unsigned seed = 1000; seed < 1030; ++seed) {
        CAPTURE(whole, warm, seed);
        Machine machine(seed, whole);
        SequentialImpulses solver;
        StepOptions stepping;
        solver.iterations = 100;
        stepping.warm_start = warm;
        double start = 0, highest = -1e9, beyond = 0;
        for (int n = 0; n < 180; ++n) {
          step(machine.world, solver, h, stepping);
          REQUIRE(all_finite(machine.world));
          if (n == 5) start = machine.energy();  // the throw has been sorted out
          if (n > 5) highest = std::max(highest, machine.energy());
          beyond = std::max(beyond, machine.beyond());
        }
        CHECK(beyond < 0.03);
        CHECK(highest - start < 2);  // of up to 300 J: what Baumgarte lends and takes back
      }
}
