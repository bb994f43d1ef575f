// The summary of a program.
#include "engine/instruments/summary.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "engine/instruments/record.h"

namespace joints {

namespace {
long long now_ns() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}
}  // namespace

void StepClock::start() { started_ = now_ns(); }
void StepClock::stop() { times_.push_back(double(now_ns() - started_) / 1000); }

double StepClock::median_us() const {
  if (times_.empty()) return 0;
  std::vector<double> sorted = times_;
  const auto middle = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

void report(const std::vector<Summary>& lines, const std::string& folder) {
  CsvFile file(folder + "/summary.csv", {"scene", "setting", "us_per_step", "gap_rms_m",
                                         "gap_max_m", "energy_drift"});
  std::printf("%-12s %-25s %8s %9s %9s %9s\n", "scene", "setting", "us/step", "gap, mm", "largest",
              "drift");
  for (const Summary& line : lines) {
    std::printf("%-12s %-25s %8.2f %9.4g %9.4g %9.3g\n", line.scene.c_str(),
                line.setting.c_str(), line.us_per_step, 1000 * line.gap_rms, 1000 * line.gap_max,
                line.energy_drift);
    file.row({line.scene, line.setting},
             {line.us_per_step, line.gap_rms, line.gap_max, line.energy_drift});
  }
}

}  // namespace joints
