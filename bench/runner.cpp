// The runner: the same measures for every scene and solver, from poses only.
#include "bench/runner.h"

#include <cmath>

#include "engine/summary.h"

namespace joints::bench {

namespace {

constexpr int steps = 300;
const real h = real(1) / 60;

// The typical distance between two joined bodies, to which gaps are compared [m].
double link_length(const Scene& scene) {
  const auto at_start = poses(scene.world.bodies);
  const Mark& mark = scene.marks.back();
  return length(at_start[mark.body2].x - at_start[mark.body1].x);
}

}  // namespace

std::string status(const Result& r, double link) {
  const bool numbers = std::isfinite(r.gap_rms) && std::isfinite(r.gap_max) &&
                       std::isfinite(r.energy_drift) && std::isfinite(r.tip_error);
  if (!numbers) return "nan";
  if (r.energy_drift > 1) return "exploded";
  if (r.energy_drift > 0.02) return "energy+";
  return r.gap_max < 0.01 * link ? "ok" : r.gap_max < 0.5 * link ? "soft" : "torn";
}

Result run(const MakeScene& make_scene, const Setting& setting, int repetitions) {
  Result result;
  StepClock clock;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    Scene scene = make_scene();
    Step step = setting.make();
    const bool measuring = repetition == 0;
    GapMeter gaps;
    const auto mass = masses(scene.world.bodies);
    const glm::dvec3 gravity(scene.world.gravity);
    std::vector<Pose> ring[3];
    poses(scene.world.bodies, ring[0]);
    const double start = potential_energy(ring[0], mass, gravity);
    for (int n = 1; n <= steps; ++n) {
      if (n > 20) clock.start();
      step(scene.world, h);
      if (n > 20) clock.stop();
      if (!measuring) continue;
      std::vector<Pose>& now = ring[n % 3];
      poses(scene.world.bodies, now);
      if (n > steps - 200) gaps.look(scene.marks, now);
      if (n == 60) {
        const glm::dvec3 miss = (now[scene.tip].x - scene.tip_reference) * scene.tip_mask;
        result.tip_error = length(miss);
      }
    }
    if (!measuring) continue;
    const Moment end{ring[(steps - 2) % 3], ring[(steps - 1) % 3], ring[steps % 3], double(h)};
    result.gap_rms = gaps.rms();
    result.gap_max = gaps.maximum();
    result.axis_error = gaps.axis_maximum();
    result.energy_drift =
        (kinetic_energy(end, mass) + potential_energy(end.now, mass, gravity) - start) /
        scene.energy_scale;
    result.status = status(result, link_length(scene));
  }
  result.us_per_step = clock.median_us();
  return result;
}

}  // namespace joints::bench
