// The runner: the same experiment for every scene and setting.
#include "bench/runner.h"

#include <algorithm>
#include <cmath>

namespace joints::bench {

namespace {

constexpr int untimed = 20;  // steps at the start of a run

// The typical distance between two joined bodies, to which gaps are compared [m].
double link_length(const Scene& scene) {
  const auto at_start = poses(scene.world.bodies);
  const Mark& mark = scene.marks.back();
  return length(at_start[mark.body2].x - at_start[mark.body1].x);
}

// A scene and a fresh solver for it.
struct Ready {
  BenchScene scene;
  Step step;
  Ready(const MakeScene& make_scene, const Setting& setting) : scene(make_scene()) {
    if (setting.prepare) setting.prepare(scene.world);
    step = setting.make();
  }
  // Steps with nothing between them.
  void time(StepClock& clock, int steps, real h) {
    for (int n = 1; n <= steps; ++n)
      if (n > untimed) clock.time([&] { step(scene.world, h); });
      else step(scene.world, h);
  }
};

// Bodies as they were a step ago, with the mean of their velocities then and now.
class Centred {
 public:
  explicit Centred(std::span<const Body> now) : before_(now.begin(), now.end()), out_(before_) {}
  std::span<const Body> after(std::span<const Body> now, int steps) {
    if (steps > 1)
      for (std::size_t k = 0; k < out_.size(); ++k) {
        out_[k] = before_[k];
        out_[k].v = (before_[k].v + now[k].v) / real(2);
        out_[k].w = (before_[k].w + now[k].w) / real(2);
      }
    before_.assign(now.begin(), now.end());
    return out_;
  }

 private:
  std::vector<Body> before_, out_;
};

Result measured(const MakeScene& make_scene, const Setting& setting, const Span& span) {
  Ready ready(make_scene, setting);
  const BenchScene& scene = ready.scene;
  const std::vector<Pose> start = poses(scene.world.bodies);
  Experiment experiment = experiment_of(ready.scene, span.steps);
  experiment.step = [&] { ready.step(ready.scene.world, span.h); };
  Centred centred(all_of(scene.world.bodies));
  int looks = 0;
  experiment.bodies = [&] {
    if (setting.show) setting.show(ready.scene.world);
    const std::span<const Body> now = all_of(scene.world.bodies);
    return setting.leapfrog ? centred.after(now, looks++) : now;
  };
  experiment.settling = last_two_thirds(span.steps);
  experiment.untimed = untimed;
  const double link = link_length(scene);
  double tip_error = 0, sideways = 0;
  const Measures measures = joints::run(experiment, [&](int n) {
    const std::span<const Body> now = all_of(scene.world.bodies);
    if (n == int(std::lround(1 / double(span.h))))
      tip_error =
          length((glm::dvec3(now[scene.tip].x) - scene.tip_reference) * scene.tip_mask);
    if (scene.forbidden == glm::dvec3(0)) return;
    for (std::size_t i = 0; i < now.size(); ++i)
      sideways = std::max(
          sideways, std::abs(dot(glm::dvec3(now[i].x) - start[i].x, scene.forbidden)));
  });
  const auto& value = scene.finding.value;
  return {measures, tip_error, sideways,
          value ? value(scene) : std::numeric_limits<double>::quiet_NaN(), status(measures, link)};
}

}  // namespace

Result run(const MakeScene& make_scene, const Setting& setting, int repetitions,
           const Span& span) {
  Result result = measured(make_scene, setting, span);
  if (repetitions == 1 || !result.finite) return result;
  StepClock clock;
  for (int n = 0; n < repetitions; ++n)
    Ready(make_scene, setting).time(clock, std::min(span.steps, span.timed), span.h);
  result.us_per_step = clock.median_us();
  return result;
}

double time_of_step(const MakeScene& make_scene, const Setting& setting, const Span& span) {
  StepClock clock(StepClock::Time::thread);
  Ready(make_scene, setting).time(clock, span.steps, span.h);
  return clock.median_us();
}

}  // namespace joints::bench
