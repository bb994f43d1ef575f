// The runner: the same measures for every scene and solver, from poses only.
#include "bench/runner.h"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/instruments/summary.h"

namespace joints::bench {

namespace {

// The typical distance between two joined bodies, to which gaps are compared [m].
double link_length(const Scene& scene) {
  const auto at_start = poses(scene.world.bodies);
  const Mark& mark = scene.marks.back();
  return length(at_start[mark.body2].x - at_start[mark.body1].x);
}

// The time that the processor has given to this thread [us].
double own_us() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e6 * double(time.tv_sec) + 1e-3 * double(time.tv_nsec);
}

// The measures of one run, filled in step by step.
class Look {
 public:
  Look(const Scene& scene, const Span& span, Result& result)
      : scene_(scene), span_(span), result_(result), mass_(masses(scene.world.bodies)),
        gravity_(scene.world.gravity), link_(link_length(scene)) {
    poses(scene.world.bodies, ring_[0]);
    start_ = ring_[0];
    at_start_ = potential_energy(ring_[0], mass_, gravity_);
  }

  void after(int step) {
    std::vector<Pose>& now = ring_[step % 3];
    poses(scene_.world.bodies, now);
    result_.steps = step;
    result_.finite = result_.finite && all_finite(scene_.world);
    if (step > span_.steps - 2 * span_.steps / 3) gaps_.look(scene_.marks, now);
    if (step == int(std::lround(1 / double(span_.h))))
      result_.tip_error = length((now[scene_.tip].x - scene_.tip_reference) * scene_.tip_mask);
    if (scene_.forbidden != glm::dvec3(0))
      for (std::size_t i = 0; i < now.size(); ++i)
        result_.sideways = std::max(
            result_.sideways, std::abs(dot(now[i].x - start_[i].x, scene_.forbidden)));
    if (step < 2) return;
    const Moment moment{ring_[(step - 2) % 3], ring_[(step - 1) % 3], now, double(span_.h)};
    result_.energy_drift =
        (kinetic_energy(moment, mass_) + potential_energy(moment.now, mass_, gravity_) -
         at_start_) /
        scene_.energy_scale;
    result_.energy_peak = std::max(result_.energy_peak, result_.energy_drift);
  }

  void end() {
    result_.gap_rms = gaps_.rms();
    result_.gap_max = gaps_.maximum();
    result_.axis_error = gaps_.axis_maximum();
    if (!result_.finite)
      result_.gap_rms = result_.gap_max = result_.energy_drift = result_.energy_peak =
          std::numeric_limits<double>::quiet_NaN();
    result_.status = status(result_, link_);
  }

 private:
  const Scene& scene_;
  const Span& span_;
  Result& result_;
  std::vector<MassProperties> mass_;
  glm::dvec3 gravity_;
  double link_, at_start_;
  std::vector<Pose> ring_[3], start_;
  GapMeter gaps_;
};

}  // namespace

bool all_finite(const World& world) {
  for (int slot = 0; slot < world.bodies.slots(); ++slot) {
    const Body& b = world.bodies.at(slot);
    if (!finite(b.x) || !finite(b.q) || !finite(b.v) || !finite(b.w)) return false;
  }
  return true;
}

std::string status(const Result& r, double link) {
  const bool numbers = r.finite && std::isfinite(r.gap_rms) && std::isfinite(r.gap_max) &&
                       std::isfinite(r.energy_drift) && std::isfinite(r.tip_error);
  if (!numbers) return "nan";
  if (r.energy_drift > 1) return "exploded";
  if (r.energy_drift > 0.02) return "energy+";
  return r.gap_max < 0.01 * link ? "ok" : r.gap_max < 0.5 * link ? "soft" : "torn";
}

Result run(const MakeScene& make_scene, const Setting& setting, int repetitions,
           const Span& span) {
  Result result;
  StepClock clock;
  const bool apart = repetitions > 1;  // the measures are taken in a run of their own
  for (int n = 0; n < repetitions + int(apart) && result.finite; ++n) {
    Scene scene = make_scene();
    if (setting.prepare) setting.prepare(scene.world);
    Step step = setting.make();
    const bool measuring = n == 0;
    if (n == 1) clock = StepClock();
    Look look(scene, span, result);
    for (int k = 1; k <= (measuring ? span.steps : std::min(span.steps, span.timed)); ++k) {
      if (k > 20) clock.start();
      step(scene.world, span.h);
      if (k > 20) clock.stop();
      if (!measuring) continue;
      if (setting.show) setting.show(scene.world);
      look.after(k);
      if (!result.finite) break;
    }
    if (measuring) look.end();
  }
  result.us_per_step = clock.median_us();
  return result;
}

double time_of_step(const MakeScene& make_scene, const Setting& setting, const Span& span) {
  Scene scene = make_scene();
  if (setting.prepare) setting.prepare(scene.world);
  const Step step = setting.make();
  std::vector<double> times;
  for (int n = 1; n <= span.steps; ++n) {
    const double before = own_us();
    step(scene.world, span.h);
    if (n > 20) times.push_back(own_us() - before);
  }
  std::sort(times.begin(), times.end());
  return times.empty() ? 0 : times[times.size() / 2];
}

}  // namespace joints::bench
