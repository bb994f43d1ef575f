// Runs a scene with a solver and measures both: how long a step takes and how well it holds.
#pragma once

#include <functional>
#include <string>

#include "bench/scenes.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// One step of a world.
using Step = std::function<void(World&, real)>;

/// A solver with its settings. `make` gives a fresh one for every run.
struct Setting {
  std::string solver, name;
  int iterations = 30;
  bool warm = false;
  std::function<Step()> make;
};

/// What one run gave.
struct Result {
  double us_per_step = 0;   ///< median over steps 21 to 300 of all repetitions [us]
  double gap_rms = 0;       ///< last 200 steps [m]
  double gap_max = 0;       ///< last 200 steps [m]
  double axis_error = 0;    ///< last 200 steps [rad]
  double energy_drift = 0;  ///< (E_end - E_0) / E_scale [1]
  double tip_error = 0;     ///< after 1 s [m]
  std::string status;       ///< ok, soft, torn, energy+, exploded or nan
};

/// 300 steps at h = 1/60, `repetitions` times; the measures are those of the first.
Result run(const MakeScene& make_scene, const Setting& setting, int repetitions);

/// The word for a run: ok (gap below 1 % of a link), soft (below half a link), torn (above),
/// energy+ (over 2 % gained), exploded (over 100 %), nan.
std::string status(const Result& result, double link);

}  // namespace joints::bench
/// @}
