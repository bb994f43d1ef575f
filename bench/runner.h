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
  std::function<void(World&)> prepare{};  ///< what the setting changes in the joints, if anything
  /// Where a solver has bodies of its own: their poses into the world, after a step and not timed.
  std::function<void(World&)> show{};
};

/// How long a run is.
struct Span {
  real h = real(1) / 60;  ///< step [s]
  int steps = 300;        ///< the gaps are measured in the last two thirds of them
  int timed = 300;        ///< steps of a repetition that is there for the time alone
};

/// What one run gave.
struct Result {
  double us_per_step = 0;   ///< median of the steps from the 21st on that were timed [us]
  double gap_rms = 0;       ///< last 200 steps of 300 [m]
  double gap_max = 0;       ///< last 200 steps of 300 [m]
  double axis_error = 0;    ///< last 200 steps of 300 [rad]
  double energy_drift = 0;  ///< (E_end - E_0) / E_scale [1]
  double tip_error = 0;     ///< after 1 s [m]; 0 where the scene has no reference
  std::string status;       ///< ok, soft, torn, energy+, exploded or nan
  bool finite = true;       ///< no body ever had a NaN or an infinity
  int steps = 0;            ///< how many there were: a run that is not finite ends there
  double energy_peak = 0;   ///< the largest (E - E_0) / E_scale on the way [1]
  double sideways = 0;      ///< the furthest that a body went in the forbidden direction [m]
};

/// True while every place, orientation and velocity of every body is an ordinary number.
bool all_finite(const World& world);

/// Runs a scene and measures it. Where one repetition is enough, its steps are timed; else as many
/// runs more as there are repetitions, and in these nothing stands between two steps.
Result run(const MakeScene& make_scene, const Setting& setting, int repetitions,
           const Span& span = {});

/// Median time of a step [us], from step 21 on, of one run in which nothing else is measured. It is
/// the time that the processor gave to the step: what else runs meanwhile counts little.
double time_of_step(const MakeScene& make_scene, const Setting& setting, const Span& span);

/// The word for a run: ok (gap below 1 % of a link), soft (below half a link), torn (above),
/// energy+ (over 2 % gained), exploded (over 100 %), nan.
std::string status(const Result& result, double link);

}  // namespace joints::bench
/// @}
