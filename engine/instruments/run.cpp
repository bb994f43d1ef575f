// Running, timing, measuring, and the table of the measures.
#include "engine/instruments/run.h"

#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

namespace joints {

// ---- the clock ----------------------------------------------------------------------------------

double StepClock::now_us() const {
  if (time_ == Time::wall)
    return std::chrono::duration<double, std::micro>(
               std::chrono::steady_clock::now().time_since_epoch()).count();
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e6 * double(time.tv_sec) + 1e-3 * double(time.tv_nsec);
}

void StepClock::time(const std::function<void()>& step) {
  const double before = now_us();
  step();
  times_.push_back(now_us() - before);
}

double StepClock::quantile_us(double share) const {
  if (times_.empty()) return 0;
  std::vector<double> sorted = times_;
  const std::size_t place = std::min(sorted.size() - 1, std::size_t(share * double(sorted.size())));
  const auto there = sorted.begin() + std::ptrdiff_t(place);
  std::nth_element(sorted.begin(), there, sorted.end());
  return *there;
}

// ---- the run ------------------------------------------------------------------------------------

std::string status(const Measures& m, double link) {
  if (!m.finite || !std::isfinite(m.gap_rms) || !std::isfinite(m.gap_max) ||
      !std::isfinite(m.energy_drift))
    return "nan";
  if (m.energy_peak > 1) return "exploded";
  if (m.energy_peak > 0.02) return "energy+";
  return m.gap_max < 0.01 * link ? "ok" : m.gap_max < 0.5 * link ? "soft" : "torn";
}

Reading reading_of(const Experiment& experiment, const std::string& of) {
  GapMeter gaps;
  experiment.gaps(gaps);
  return {of, gaps.maximum(), energy(experiment.bodies(), experiment.gravity)};
}

int steps_in(double seconds, real h) {
  return std::max(1, int(std::lround(seconds / double(h))));
}

Run::Run(Experiment experiment)
    : experiment_(std::move(experiment)),
      start_(energy(experiment_.bodies(), experiment_.gravity)) {
  look();
}

void Run::step() {
  ++now_.steps;
  if (!now_.finite) return;  // there is nothing left that could move
  try {
    if (now_.steps > experiment_.untimed) clock_.time(experiment_.step);
    else experiment_.step();
  } catch (const std::runtime_error&) {  // overflow, or a step that found no poses
    now_.finite = false;
  }
  look();
}

void Run::look() {
  const std::span<const Body> bodies = experiment_.bodies();
  now_.finite = now_.finite && all_finite(bodies);
  if (now_.steps >= experiment_.settling) experiment_.gaps(gaps_);
  now_.energy_drift = (energy(bodies, experiment_.gravity) - start_) / experiment_.energy_scale;
  now_.energy_peak = std::max(now_.energy_peak, now_.energy_drift);
}

Measures Run::measures() const {
  Measures out = now_;
  out.us_per_step = clock_.median_us();
  out.gap_rms = gaps_.rms();
  out.gap_max = gaps_.maximum();
  out.axis_error = gaps_.axis_maximum();
  if (!out.finite)
    out.gap_rms = out.gap_max = out.energy_drift = out.energy_peak =
        std::numeric_limits<double>::quiet_NaN();
  return out;
}

Measures run(const Experiment& experiment, const std::function<void(int)>& look) {
  Run run(experiment);
  look(0);
  for (int n = 1; n <= experiment.steps && run.now().finite; ++n) {
    run.step();
    look(n);
  }
  return run.measures();
}

// ---- the summary --------------------------------------------------------------------------------

void report(const std::vector<Summary>& lines, const std::string& folder) {
  CsvFile file(folder + "/summary.csv", {"scene", "setting", "us_per_step", "gap_rms_m",
                                         "gap_max_m", "energy_drift"});
  std::printf("%-12s %-25s %8s %9s %9s %9s\n%46s %9s %9s %9s\n", "scene", "setting", "a step",
              "gap RMS", "gap max", "drift", "[us]", "[mm]", "[mm]", "[1]");
  for (const Summary& line : lines) {
    std::printf("%-12s %-25s %8.2f %9.4g %9.4g %9.3g\n", line.scene.c_str(),
                line.setting.c_str(), line.us_per_step, 1000 * line.gap_rms, 1000 * line.gap_max,
                line.energy_drift);
    file.row({line.scene, line.setting},
             {line.us_per_step, line.gap_rms, line.gap_max, line.energy_drift});
  }
  std::puts("drift: energy at the end less that at the start, by the scene's own scale");
}

}  // namespace joints
