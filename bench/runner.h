// Runs a scene with a solver and measures both: how long a step takes and how well it holds.
#pragma once

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
  /// Where a solver has bodies of its own: they are put into the world, before a look, not timed.
  std::function<void(World&)> show{};
  /// The velocities belong to the middles of the steps: the energy is that of the poses between two
  /// steps and of the mean of the velocities about them.
  bool leapfrog = false;
  /// The energy is that of a step ago, with velocities by central differences of the poses: one
  /// measure for all loops, whatever their velocities belong to. It smears impacts.
  bool differences = false;
};

/// How long a run is.
struct Span {
  real h = real(1) / 60;  ///< step [s]
  int steps = 300;        ///< the gaps are measured in the last two thirds of them
  int timed = 300;        ///< steps of a repetition that is there for the time alone
};

/// What one run gave; the median is of the steps from the 21st on that were timed.
struct Result : Measures {
  double tip_error = 0;  ///< after 1 s [m]; 0 where the scene has no reference
  double sideways = 0;   ///< the furthest that a body went in the forbidden direction [m]
  double found = std::numeric_limits<double>::quiet_NaN();  ///< the scene's finding, if it has one
  std::string status{};  ///< ok, soft, torn, energy+, exploded or nan
};

/// Runs a scene and measures it. Where one repetition is enough, its steps are timed; else as many
/// runs more as there are repetitions, and in these nothing stands between two steps.
Result run(const MakeScene& make_scene, const Setting& setting, int repetitions,
           const Span& span = {});

/// Times the steps of one run from step 21 on, in which nothing else is measured.
void time_steps(StepClock& clock, const MakeScene& make_scene, const Setting& setting,
                const Span& span);
/// The median time of such a step [us]. It is the time that the processor gave to the step: what
/// else runs meanwhile counts little.
double time_of_step(const MakeScene& make_scene, const Setting& setting, const Span& span);

/// Bytes that the program has taken from the heap and not given back, with what the heap itself
/// needs for them; 0 where this cannot be asked.
double bytes_in_use();

}  // namespace joints::bench
/// @}
