// One run of an experiment: steps that are timed, and after each of them a look at the gaps and at
// the energy. Chapters' programs and benchmarks measure with it, whatever loop does the steps.
#pragma once

#include <functional>
#include <string>

#include "engine/instruments/measure.h"
#include "engine/instruments/record.h"

/// \addtogroup measuring
/// @{
namespace joints {

/// Times steps, and tells the median.
class StepClock {
 public:
  /// Which time passes.
  enum class Time {
    wall,   ///< on the wall
    thread  ///< that the processor gave to this thread: what else runs meanwhile counts little
  };
  explicit StepClock(Time time = Time::wall) : time_(time) {}  ///< nothing timed yet
  void time(const std::function<void()>& step);  ///< does a step
  /// The time below which this share of the steps stays [us], 0 before the first step.
  double quantile_us(double share) const;
  double median_us() const { return quantile_us(0.5); }  ///< [us], 0 before the first step

 private:
  double now_us() const;
  Time time_;
  std::vector<double> times_;
};

/// What one run gave.
struct Measures {
  double us_per_step = 0;   ///< median of the steps that were timed [us]
  double gap_rms = 0;       ///< of all gaps at the moments that count [m]
  double gap_max = 0;       ///< [m]
  double axis_error = 0;    ///< the largest [rad]
  double energy_drift = 0;  ///< (E_end - E_0) / E_scale [1]
  double energy_peak = 0;   ///< the largest (E - E_0) / E_scale on the way [1]
  bool finite = true;       ///< no body ever had a NaN or an infinity; else the rest is NaN
  int steps = 0;            ///< how many there were
};

/// The word for a run: ok (gap below 1 % of a link), soft (below half a link), torn (above),
/// energy+ (over 2 % gained at any time), exploded (over 100 %), nan.
/// \param link typical distance between two joined bodies [m]
std::string status(const Measures& measures, double link);

/// What is run and what is looked at. The energy is that of the bodies' state: every loop has it
/// after each step, blows and bodies that are taken away between two steps included, which a
/// difference of poses would smear.
struct Experiment {
  std::function<void()> step;                     ///< one step; it alone is timed
  std::function<std::span<const Body>()> bodies;  ///< as they stand
  std::function<void(GapMeter&)> gaps;            ///< adds every gap as it is
  int steps = 0;                                  ///< how many to do
  vec3 gravity{0, real(-9.81), 0};                ///< [m/s^2]
  double energy_scale = 1;  ///< what the change of the energy is divided by [J]
  int settling = 0;         ///< the gaps count from the moment after so many steps
  int untimed = 0;          ///< how many steps come before those that are timed
};

/// The experiment as it stands. \param of which of several side by side
Reading reading_of(const Experiment& experiment, const std::string& of = "");

/// How many steps of length h make up a time, at least one. \param seconds [s]
int steps_in(double seconds, real h);
/// Where the gaps of the last two thirds of so many steps begin to count.
constexpr int last_two_thirds(int steps) { return steps - 2 * steps / 3 + 1; }

/// An experiment step by step, for those who run several side by side.
class Run {
 public:
  explicit Run(Experiment experiment);  ///< looks at the start
  void step();  ///< does a step, and looks; none after one that has overflowed
  Measures measures() const;            ///< of the run so far
  /// Of these, at once: the energies, how many steps, and whether all was finite.
  const Measures& now() const { return now_; }

 private:
  void look();
  Experiment experiment_;
  double start_;
  StepClock clock_;
  GapMeter gaps_;
  Measures now_;
};

/// Runs an experiment to its end, or until a number is no ordinary one.
/// \param look called before the first step with 0, and after step n with n
Measures run(const Experiment& experiment, const std::function<void(int)>& look = [](int) {});

}  // namespace joints
/// @}
