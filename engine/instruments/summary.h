// One line of a program's summary: the scene, what a step costs and how well it holds.
#pragma once

#include <string>
#include <vector>

/// \addtogroup measuring
/// @{
namespace joints {

/// What `./wb tour` shows of a scene.
struct Summary {
  std::string scene, setting;  ///< what ran, and how
  double us_per_step = 0;   ///< median time of a step [us]
  double gap_rms = 0;       ///< over all joints and steps [m]
  double gap_max = 0;       ///< [m]
  double energy_drift = 0;  ///< (E_end - E_0) / E_scale [1]
};

/// Times steps: start, stop, and the median of what lay between.
class StepClock {
 public:
  void start();              ///< before a step
  void stop();               ///< after it
  double median_us() const;  ///< [us], 0 before the first stop

 private:
  long long started_ = 0;
  std::vector<double> times_;
};

/// Prints the lines as a table and writes them to `folder`/summary.csv.
void report(const std::vector<Summary>& lines, const std::string& folder);

}  // namespace joints
/// @}
