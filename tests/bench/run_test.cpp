// The runner on a body whose motion is known, its words, and the contraction rate.
#include "engine/instruments/rate.h"
#include "engine/instruments/run.h"

#include "engine/kept/state.h"
#include "joints/ball_joint.h"
#include "tests/checker/catch.h"
#include "tests/oracle/oracle.h"

using namespace joints;
using namespace joints::testing;

namespace {

// A ball of 2 kg that moves 1 m to the right a step and is 2 m/s faster after each; the gap is how
// far it has come.
struct Cart {
  Body body = ball(2, 1, vec3(0));
  Experiment experiment(int steps) {
    return {.step =
                [this] {
                  body.x.x += 1;
                  body.v.x += 2;
                },
            .bodies = [this] { return std::span<const Body>(&body, 1); },
            .gaps = [this](GapMeter& meter) { meter.add(double(body.x.x)); },
            .steps = steps,
            .gravity = vec3(-1, 0, 0),
            .energy_scale = 10};
  }
};

}  // namespace

TEST_CASE("a run looks at the start and after each step and divides energy by its scale") {
  Cart cart;
  std::vector<int> looks;
  const Measures found = run(cart.experiment(3), [&](int n) { looks.push_back(n); });
  CHECK(looks == std::vector<int>{0, 1, 2, 3});
  CHECK(found.steps == 3);
  CHECK(found.finite);
  CHECK(found.gap_max == 3);
  CHECK(found.gap_rms == Approx(std::sqrt((0 + 1 + 4 + 9) / 4.0)).epsilon(1e-12));
  CHECK(found.energy_drift == Approx((0.5 * 2 * 36 + 2 * 3) / 10).epsilon(1e-6));
}

TEST_CASE("gaps count from the settling on and the highest energy on the way is kept") {
  Cart cart;
  Experiment experiment = cart.experiment(3);
  experiment.settling = last_two_thirds(3);
  const Measures found = run(experiment, [&](int n) {
    if (n == 2) cart.body.v.x = -2;  // and so at rest after the last step
  });
  CHECK(found.gap_rms == Approx(std::sqrt((4 + 9) / 2.0)).epsilon(1e-12));
  CHECK(found.energy_drift == Approx(2 * 3 / 10.0).epsilon(1e-6));
  CHECK(found.energy_peak == Approx((0.5 * 2 * 16 + 2 * 2) / 10).epsilon(1e-6));
}

TEST_CASE("a run ends where a number is no ordinary one and none of its measures is a number") {
  Cart cart;
  const Measures found = run(cart.experiment(9), [&](int n) {
    if (n == 4) cart.body.w.y = unbounded;
  });
  CHECK(found.steps == 5);
  CHECK_FALSE(found.finite);
  CHECK(std::isnan(found.gap_rms));
  CHECK(std::isnan(found.energy_peak));
  CHECK(status(found, 1) == "nan");
}

TEST_CASE("a run gets the word of its worst fault") {
  Measures found;
  CHECK(status(found, 1) == "ok");
  found.gap_max = 0.011;
  CHECK(status(found, 1) == "soft");
  found.gap_max = 0.6;
  CHECK(status(found, 1) == "torn");
  found.energy_drift = -0.1;  // gained on the way counts though it is lost again at the end
  found.energy_peak = 0.03;
  CHECK(status(found, 1) == "energy+");
  found.energy_peak = 1.1;
  CHECK(status(found, 1) == "exploded");
  found.gap_rms = std::nan("");
  CHECK(status(found, 1) == "nan");
  Measures lost;
  lost.finite = false;
  CHECK(status(lost, 1) == "nan");
}

TEST_CASE("the contraction rate is that of the slowest mode and 0 where all is solved at once") {
  double slow = 1, fast = 1;
  const auto two_modes = [&] { return (slow *= 0.9) + (fast *= -0.5); };
  CHECK(contraction_rate(two_modes, 200) == Approx(0.9).epsilon(1e-9));
  int left = 50;
  const auto ends = [&] { return left-- > 0 ? std::pow(0.3, 50 - left) : 0; };
  CHECK(contraction_rate(ends, 1000) == Approx(0.3).epsilon(1e-9));
  CHECK(contraction_rate([] { return 0.0; }, 10) == 0);
}

TEST_CASE("the contraction rate of a world that moves is measured without a trace in it") {
  World world;
  std::vector<BodyId> ids{world.add(static_body(vec3(0)))};
  for (int k = 1; k <= 4; ++k) {
    ids.push_back(world.add(ball(1, real(0.2), vec3(real(k), 0, 0))));
    const Body &a = world.bodies[ids[std::size_t(k - 1)]], &b = world.bodies[ids.back()];
    const vec3 middle = (a.x + b.x) / real(2);
    world.add<BallJoint>(ids[std::size_t(k - 1)], ids.back(), point_at(a, b, middle));
  }
  SequentialImpulses solver;
  for (int n = 0; n < 20; ++n) step(world, solver, real(1) / 60, {.warm_start = true});
  const State before = save(world);
  const double rate = contraction_rate(world, 600);
  CHECK(rate > 0.5);
  CHECK(rate < 1);
  CHECK(save(world) == before);
}
