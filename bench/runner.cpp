// The runner: the same experiment for every scene and setting.
#include "bench/runner.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

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

// Velocity of a body that was at one pose and is at the other after this time [s].
void set_velocity(Body& body, const Body& from, const Body& to, real time) {
  quat q = to.q * conjugate(from.q);
  if (q.w < 0) q = -q;
  const vec3 half_sine(q.x, q.y, q.z);
  const real sine = length(half_sine);
  body.v = (to.x - from.x) / time;
  body.w = sine > 0 ? 2 * std::atan2(sine, q.w) / (sine * time) * half_sine : vec3(0);
}

// Bodies as they were a step ago, with velocities that belong there: the mean of those then and
// now, or differences of the poses about them.
class Centred {
 public:
  Centred(std::span<const Body> now, bool differences, real h)
      : differences_(differences), h_(h), before_(now.begin(), now.end()), earlier_(before_),
        out_(before_) {}
  std::span<const Body> after(std::span<const Body> now, int steps) {
    if (steps > 1)
      for (std::size_t k = 0; k < out_.size(); ++k) {
        out_[k] = before_[k];
        if (differences_) {
          set_velocity(out_[k], earlier_[k], now[k], 2 * h_);
          continue;
        }
        out_[k].v = (before_[k].v + now[k].v) / real(2);
        out_[k].w = (before_[k].w + now[k].w) / real(2);
      }
    earlier_ = before_;
    before_.assign(now.begin(), now.end());
    return out_;
  }

 private:
  bool differences_;
  real h_;
  std::vector<Body> before_, earlier_, out_;
};

Result measured(const MakeScene& make_scene, const Setting& setting, const Span& span) {
  Ready ready(make_scene, setting);
  const BenchScene& scene = ready.scene;
  const std::vector<Pose> start = poses(scene.world.bodies);
  Experiment experiment = experiment_of(ready.scene, span.steps);
  experiment.step = [&] { ready.step(ready.scene.world, span.h); };
  Centred centred(all_of(scene.world.bodies), setting.differences, span.h);
  int looks = 0;
  experiment.bodies = [&] {
    if (setting.show) setting.show(ready.scene.world);
    const std::span<const Body> now = all_of(scene.world.bodies);
    const bool later = setting.leapfrog || setting.differences;
    return later ? centred.after(now, looks++) : now;
  };
  experiment.settling = last_two_thirds(span.steps);
  experiment.untimed = untimed;
  const double link = link_length(scene);
  double tip_error = 0, sideways = 0;
  const Measures measures = joints::run(experiment, [&](int n) {
    const std::span<const Body> now = all_of(scene.world.bodies);
    if (n == int(std::lround(scene.tip_time / double(span.h))))
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

// A step that says that it cannot go on ends a run, and no more is known of it.
Result measured_or_refused(const MakeScene& make_scene, const Setting& setting, const Span& span) {
  try {
    return measured(make_scene, setting, span);
  } catch (const std::runtime_error&) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    Result lost;
    lost.gap_rms = lost.gap_max = lost.axis_error = lost.energy_drift = lost.energy_peak = none;
    lost.tip_error = lost.sideways = none;
    lost.finite = false;
    lost.status = "refused";
    return lost;
  }
}

}  // namespace

Result run(const MakeScene& make_scene, const Setting& setting, int repetitions,
           const Span& span) {
  Result result = measured_or_refused(make_scene, setting, span);
  if (repetitions == 1 || !result.finite) return result;
  StepClock clock;
  for (int n = 0; n < repetitions; ++n)
    Ready(make_scene, setting).time(clock, std::min(span.steps, span.timed), span.h);
  result.us_per_step = clock.median_us();
  return result;
}

void time_steps(StepClock& clock, const MakeScene& make_scene, const Setting& setting,
                const Span& span) {
  try {
    Ready(make_scene, setting).time(clock, span.steps, span.h);
  } catch (const std::runtime_error&) {  // its steps until then are timed
  }
}

double time_of_step(const MakeScene& make_scene, const Setting& setting, const Span& span) {
  StepClock clock(StepClock::Time::thread);
  time_steps(clock, make_scene, setting, span);
  return clock.median_us();
}

double time_of_run(const MakeScene& make_scene, const Setting& setting, real h, int untimed,
                   int timed) {
  Ready ready(make_scene, setting);
  for (int n = 0; n < untimed; ++n) ready.step(ready.scene.world, h);
  StepClock clock(StepClock::Time::thread);
  clock.time([&] {
    for (int n = 0; n < timed; ++n) ready.step(ready.scene.world, h);
  });
  return clock.median_us() / timed;
}

double bytes_in_use() {
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 33)
  const struct mallinfo2 info = mallinfo2();
  return double(info.uordblks) + double(info.hblkhd);
#else
  return 0;
#endif
}

}  // namespace joints::bench
