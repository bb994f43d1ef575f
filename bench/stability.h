// The stability suite: seventeen cases of stiff, extreme, redundant or invalid scenes, each a
// function that reports its lines one by one. `./wb bench --stability` runs them all.
#pragma once

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "bench/runner.h"
#include "direct/direct_solver.h"
#include "engine/sequential_impulses.h"
#include "engine/steps/step.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// The value of an empty entry of a line.
inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A line of the table: the case, the expected and the measured number.
struct Line {
  std::string id{};         ///< X1 to X17
  std::string method{};     ///< solver and setting, or another varied quantity in words
  std::string parameter{};  ///< the quantity in `value`, with its unit
  double value = none;
  double expected = none, measured = none;
  std::string status{};  ///< of a run: its classification; of a known number: ok, off
  double gap_rms = none, gap_max = none;           ///< [m]
  double energy_drift = none, energy_peak = none;  ///< at the end; the largest [1]
  double rho = none;  ///< factor per iteration in the long run, of possible motions [1]
  double criterion = none;  ///< warm: 1 where rho^k (1 + beta) < 1, else 0
  double rho_any = none;    ///< rho of any motion, also against the hinges' axes [1]
};
using Tell = std::function<void(const Line&)>;  ///< receives every line as soon as it is known

/// A case of the suite.
struct Case {
  std::string id, what;
  std::function<void(bool quick, const Tell&)> run;  ///< quick: few values
  bool watched = false;  ///< small worlds, each in a Watch: any solver can be used
};
/// All of them, X1 to X17; some have two entries.
std::vector<Case> cases();

// ---- lines --------------------------------------------------------------------------------------

/// The line of a known number: ok if the difference is at most `tolerance`, nan if the measured
/// number is NaN, off otherwise.
Line compared(Line line, double expected, double measured, double tolerance);
/// The line of a rule: ok if it holds, nan if the measured number is NaN, off otherwise.
Line judged(Line line, double measured, bool holds);
/// The line of a scene that was run.
Line of_run(Line line, const Result& result);
/// A tolerance that depends on the number type.
inline double digits(double in_double, double in_float) {
  return sizeof(real) == 8 ? in_double : in_float;
}

// ---- methods ------------------------------------------------------------------------------------

/// A setting of the solver: a row of the maps.
struct Method {
  std::string name{};
  int iterations = 30;   ///< iterations per step, or per substep
  bool warm = false;
  real beta = real(0.2);
  int projections = 0;
  int substeps = 1;
  bool whole = true;     ///< hinges as one block of five rows, not of three and of two
  bool direct = false;   ///< chapter 9's solver, with half a kick in the first step
  int newton = 0;        ///< direct only
  real added_inertia = 0;    ///< direct only
};
/// The methods of the maps. The default of beta is 0.2, with projection 0. The last method is for
/// hinges only.
std::vector<Method> methods();
/// As a setting of the runner.
Setting setting_of(const Method& method);

/// Gives all bodies of a scene velocities, so that all modes of the iterations are excited.
/// \param planar only velocities perpendicular to its forbidden direction: a plane chain stays
/// plane
void kick(BenchScene& scene, bool planar);

/// The rates of a scene's iterations, each a lower bound where it is very close to 1.
struct Rates {
  double possible;  ///< of the scene's possible motions; used by the criterion
  double any;       ///< of any motion
};
/// Measures both on the first step of the scene.
Rates rates_of(const MakeScene& make);
/// Puts rho and the criterion into the line of a warm method.
void add_criterion(Line& line, const Method& method, const Rates& rates);

/// Steps a small world and checks that it stays finite.
struct Watch {
  /// True: use the direct solver, whatever the settings of the other one.
  static inline bool directly = false;
  World& world;
  SequentialImpulses solver{};
  StepOptions stepping{};
  bool finite = true;
  DirectSolver direct = DirectSolver::velocities_only();
  void step(real h) {
    if (!finite) return;
    try {
      joints::step(world, directly ? static_cast<Solver&>(direct) : solver, h, stepping);
    } catch (const std::overflow_error&) {  // all_finite() sees it
    }
    finite = all_finite(all_of(world.bodies));
  }
  /// The number, or NaN if a body was not finite at some time.
  double seen(double number) const { return finite ? number : none; }
  /// The maximum of a non-negative value over this number of steps, or NaN.
  double largest(int steps, real h, const std::function<double()>& value) {
    double most = 0;
    for (int k = 0; k < steps; ++k) {
      step(h);
      most = std::max(most, value());
    }
    return seen(most);
  }
};

// ---- the cases ----------------------------------------------------------------------------------

void mass_ratios(bool quick, const Tell& tell);         ///< X1, the map
void feedback_of_one(bool quick, const Tell& tell);     ///< X2, one joint
void feedback_of_many(bool quick, const Tell& tell);    ///< X2, the map
void steps(bool quick, const Tell& tell);               ///< X3, the map
void truncation(bool quick, const Tell& tell);          ///< X3, one hinge, down to rounding
void lengths(bool quick, const Tell& tell);             ///< X4, the map
void coincident_points(bool quick, const Tell& tell);   ///< X5
void static_bodies(bool quick, const Tell& tell);       ///< X6
void bent_hinges(bool quick, const Tell& tell);         ///< X7
void spinning(bool quick, const Tell& tell);            ///< X8, a free box
void spinning_hinge(bool quick, const Tell& tell);      ///< X8
void far_away(bool quick, const Tell& tell);            ///< X9
void masses_apart(bool quick, const Tell& tell);        ///< X10
void limits_hit(bool quick, const Tell& tell);          ///< X11
void motors(bool quick, const Tell& tell);              ///< X12
void motors_into_limits(bool quick, const Tell& tell);  ///< X13
void redundant(bool quick, const Tell& tell);           ///< X14
void iteration_rates(bool quick, const Tell& tell);         ///< X15
void bad_input(bool quick, const Tell& tell);           ///< X16
void a_long_time(bool quick, const Tell& tell);         ///< X17

}  // namespace joints::bench
/// @}
