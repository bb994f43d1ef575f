// Runs a scene with a solver and measures the time of a step and the errors.
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
  std::function<void(World&)> prepare{};  ///< changes of the joints by the setting, if any
  /// For a solver with bodies of its own: copies them into the world before a measurement; not
  /// timed.
  std::function<void(World&)> show{};
  /// The velocities belong to the middle of the steps: the energy is computed from the poses
  /// between two steps and the mean of the velocities before and after.
  bool leapfrog = false;
  /// The energy is that of the previous step, with velocities by central differences of the poses:
  /// the same measure for all loops, whatever the time of their velocities. It smears impacts.
  bool differences = false;
  /// What part of a step its velocities are ahead where it begins with those of the start: half a
  /// substep; 0 for a method that is of second order by itself (start.h).
  double lag = 0;
  bool satisfy = false;  ///< it needs velocities at the start that its joints permit
};

/// The duration of a run.
struct Span {
  real h = real(1) / 60;  ///< step [s]
  int steps = 300;        ///< the gaps are measured in the last two thirds of them
  int timed = 300;        ///< steps of a repetition for timing only
};

/// The results of one run; the median is over the timed steps from the 21st on.
struct Result : Measures {
  double tip_error = 0;  ///< at BenchScene::tip_time [m]; 0 if the scene has no reference
  double sideways = 0;   ///< largest displacement in the forbidden direction [m]
  double found = std::numeric_limits<double>::quiet_NaN();  ///< the scene's finding, if it has one
  /// ok, soft, torn, energy+, exploded or nan; refused: the method itself gave up on the way
  std::string status{};
};

/// Runs a scene and measures it. With one repetition the steps of this run are timed; otherwise
/// each repetition is an additional run with no measurements between its steps.
Result run(const MakeScene& make_scene, const Setting& setting, int repetitions,
           const Span& span = {});

/// Times the steps of one run from step 21 on, in which nothing else is measured.
void time_steps(StepClock& clock, const MakeScene& make_scene, const Setting& setting,
                const Span& span);
/// The median time of such a step [us]. It is processor time: other programs affect it little.
double time_of_step(const MakeScene& make_scene, const Setting& setting, const Span& span);

/// The mean time of this many steps after others that do not count [us], in processor time, from
/// two readings of the clock: a reading takes as long as a short step.
double time_of_run(const MakeScene& make_scene, const Setting& setting, real h, int untimed,
                   int timed);

/// Bytes of the heap in use by the program, including the heap's own overhead; 0 if the system does
/// not report it.
double bytes_in_use();

}  // namespace joints::bench
/// @}
