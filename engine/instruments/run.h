// One run of an experiment: timed steps, and after each of them a measurement of the gaps and of
// the energy. Chapters' programs and benchmarks measure with it, whatever loop performs the steps.
#pragma once

#include <functional>
#include <string>

#include "engine/instruments/measure.h"
#include "engine/instruments/record.h"

/// \addtogroup measuring
/// @{
namespace joints {

/// Times steps and computes quantiles.
class StepClock {
 public:
  /// Which clock is read.
  enum class Time {
    wall,   ///< wall time
    thread  ///< processor time of this thread: other programs affect it little
  };
  explicit StepClock(Time time = Time::wall) : time_(time) {}  ///< no step timed yet
  void time(const std::function<void()>& step);  ///< performs a step and times it
  /// Quantile of the step times [us], 0 before the first step. \param share fraction of the steps
  double quantile_us(double share) const;
  double median_us() const { return quantile_us(0.5); }  ///< [us], 0 before the first step

 private:
  double now_us() const;
  Time time_;
  std::vector<double> times_;
};

/// The results of one run.
struct Measures {
  double us_per_step = 0;   ///< median of the timed steps [us]
  double gap_rms = 0;       ///< of all gaps after the settling steps [m]
  double gap_max = 0;       ///< [m]
  double axis_error = 0;    ///< the largest [rad]
  double energy_drift = 0;  ///< (E_end - E_0) / E_scale [1]
  double energy_peak = 0;   ///< the largest (E - E_0) / E_scale during the run [1]
  bool finite = true;       ///< false: a body had a NaN or an infinity; the rest is NaN
  int steps = 0;            ///< number of steps performed
};

/// Classifies a run: ok (gap below 1 % of a link), soft (below half a link), torn (above),
/// energy+ (over 2 % gained at any time), exploded (over 100 %), nan.
/// \param link typical distance between two joined bodies [m]
std::string status(const Measures& measures, double link);

/// The step to run and the quantities to measure. The energy is computed from the state of the
/// bodies, which every loop has after each step. Unlike a difference of poses it does not smear
/// impacts, or bodies that are removed between two steps.
struct Experiment {
  std::function<void()> step;                     ///< one step; it alone is timed
  std::function<std::span<const Body>()> bodies;  ///< in their present state
  std::function<void(GapMeter&)> gaps;            ///< adds every present gap
  int steps = 0;                                  ///< number of steps to perform
  vec3 gravity{0, real(-9.81), 0};                ///< [m/s^2]
  double energy_scale = 1;  ///< divisor of the change of the energy [J]
  int settling = 0;         ///< the gaps are measured from the end of this step on
  int untimed = 0;          ///< number of steps before the timed ones
};

/// The present reading of an experiment. \param of name of one of several side by side
Reading reading_of(const Experiment& experiment, const std::string& of = "");

/// The number of steps of length h in a time, at least one. \param seconds [s]
int steps_in(double seconds, real h);
/// The step at which the last two thirds of this number of steps begin.
constexpr int last_two_thirds(int steps) { return steps - 2 * steps / 3 + 1; }

/// An experiment step by step, for running several side by side.
class Run {
 public:
  explicit Run(Experiment experiment);  ///< measures the initial state
  void step();  ///< performs a step and measures; none after an overflow
  Measures measures() const;            ///< of the run so far
  /// The measures that are known without computation: energies, number of steps, finite.
  const Measures& now() const { return now_; }

 private:
  void look();
  Experiment experiment_;
  double start_;
  StepClock clock_;
  GapMeter gaps_;
  Measures now_;
};

/// Runs an experiment to its end, or until a number is not finite.
/// \param look called before the first step with 0, and after step n with n
Measures run(const Experiment& experiment, const std::function<void(int)>& look = [](int) {});

/// The entry of a scene in `./wb tour`: the measures of a run, its scene and its setting.
struct Summary : Measures {
  std::string scene{}, setting{};  ///< names of the scene and of the setting
};

/// Prints the lines as a table and writes them to `folder`/summary.csv.
void report(const std::vector<Summary>& lines, const std::string& folder);

}  // namespace joints
/// @}
