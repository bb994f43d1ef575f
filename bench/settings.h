// The settings for error against run time: every solver with all its settings, and the scenes on
// which they are meaningful. Each setting is a line in settings.cpp.
#pragma once

#include <vector>

#include "bench/orders.h"
#include "bench/own_loop.h"
#include "bench/runge_kutta.h"
#include "bench/runner.h"
#include "engine/sequential_impulses.h"
#include "engine/simd/packed.h"
#include "engine/steps/step.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// Which loop solves the rows.
enum class Loop {
  rows,       ///< the engine's own, any row
  packed,     ///< packed blocks, one at a time
  lanes,      ///< packed blocks, eight (float) or four (double) at a time
  hinges,     ///< chapter 7's: hinges only, one chain per lane; new bodies in every run
  textbook,   ///< a class per joint, set up once per step
  recomputed,  ///< the same, set up anew in every iteration
  flat,       ///< the textbook's hinges in one array, without the virtual call
  direct,     ///< all joints at once, chapter 9
  runge_kutta,  ///< of order 4, on the factor of chapter 9
  tree,         ///< reduced coordinates, leapfrog
  tree_runge_kutta,  ///< the same, of order 4
  xpbd,       ///< rows solved on positions, see bench/next_door
  gradients,  ///< conjugate gradients, equality rows only
  nonsmooth   ///< nonsmooth nonlinear conjugate gradients, any row
};

/// A line of the figures: a solver, and its settings and those of the joints.
struct Way {
  std::string name{};    ///< the settings, in words without a comma
  std::string scenes{};  ///< keys of the scenes on which it is tried, with blanks between
  Loop loop = Loop::rows;
  Packing packing = Packing::automatic;  ///< packed and lanes only
  Visits visits = Visits::chain_a_lane;  ///< hinges only
  Order order = Order::forward;      ///< rows only
  bool warm = false;        ///< begin with the impulses of the last step
  bool row_by_row = false;  ///< rows only
  bool whole = true;        ///< false: a hinge's point and its axis are blocks of their own
  int projections = 0;      ///< iterations of position projection after a step
  real beta = real(0.2);    ///< of every joint [1]
  real relaxation = 1;      ///< over-relaxation [1]; not the textbook's
  int substeps = 1;         ///< the iterations of a step are divided among them
  int relax = 0;            ///< relax iterations of a substep, rows only
  int split = 0;            ///< iterations of a substep on split impulses, rows only
  real frequency = 0;       ///< of springs in place of beta [Hz]
  bool leapfrog = false;    ///< half a kick in the first step
  int newton = 0;           ///< direct only: iterations on the positions
  real added_inertia = 0;       ///< direct only
  real tolerance = 0;       ///< gradients only: where they stop [1]
  int most = 200;           ///< largest number of iterations that is measured
  bool quick = false;       ///< also in the short benchmark

  /// \param scene a key
  bool means_something_on(const std::string& scene) const;
  std::string solver() const;  ///< the name of its loop
  bool of_second_order() const;  ///< of order 2 or more whatever velocities it begins with
  /// Iterations per substep for this number per step.
  int iterations_of(int a_step) const;
  /// As a setting of the runner.
  Setting setting(int iterations_a_step) const;
};
/// All of them.
std::vector<Way> ways();

/// The two quantities that a front compares: time and error.
struct Cost {
  double time;   ///< [us]
  double error;  ///< in the unit of the measured quantity
};
/// The indices of those to which no other is superior in both, fastest first. An error counts as
/// smaller only if it differs by a thousandth, more than rounding. An entry without a finite error
/// is not in the front.
std::vector<int> pareto_front(const std::vector<Cost>& costs);

}  // namespace joints::bench
/// @}
