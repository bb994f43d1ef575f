// Measures every method on a scene of a program: error against run time, with a recommendation.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/world.h"

/// \defgroup compare Comparing methods
/// \brief Error against run time on a program's own scene, with a recommendation.
/// @{
namespace joints {

/// What a program wants of its scene. An aggregate: set only the members that matter.
struct Wish {
  double seconds = 5;       ///< simulated time [s]
  real h = real(1) / 60;    ///< the step [s]
  double gap = 1e-3;        ///< largest error of a row that is a length [m]
  double angle = 1e-2;      ///< largest error of a row that is an angle [rad]
  double depth = 1e-2;      ///< how far limits and contacts may be passed, also soft ones [m, rad]
  double times = 10;        ///< the recommended one must hold this many times as long; 1: not
  double distance = 1e300;  ///< greatest distance of a body from the reference [m]
  double budget = 1e300;    ///< largest median of the time of a step [us]
  double patience = 20;     ///< processor time of the reference, and of a longer run, about [s]
  /// Called before each step with the time [s]: what moves targets and motors. May be empty.
  std::function<void(World&, double)> control{};
};

/// What a method has done with the scene.
struct MethodResult {
  std::string name;        ///< in words
  std::string code;        ///< the lines that choose it
  double us = 0;           ///< median processor time of a step [us]
  double spread = 0;       ///< distance of the quartiles of these times, over the median [1]
  double gap = 0;          ///< largest error of a row that is a length [m]
  double angle = 0;        ///< largest error of a row that is an angle [rad]
  double depth = 0;        ///< how far limits and contacts were passed [m or rad]
  double distance = 0;     ///< of any body from the reference, as long as there is one [m]
  double energy = 0;       ///< kinetic and potential energy gained from first to last [J]
  std::string failed{};    ///< what stopped it, or empty
  std::string said{};      ///< the first sentence of a step that could not hold everything
  int steps_said = 0;      ///< the number of such steps
  double seconds = 0;      ///< that it was run; of those recommended, in the longer run [s]
  bool meets = false;      ///< all that the Wish says, in a longer run, too, where there was one
};

/// All methods on one scene.
struct Comparison {
  std::vector<MethodResult> methods;  ///< in the order of the list
  int recommended = -1;         ///< index of the fastest one that meets the wish; -1: none does
  double reference_until = 0;   ///< until then two refinements agree to a third of Wish::gap [s]
  double reference_apart = 0;   ///< how far these two are apart at that time, at most [m]
  Wish wish;                    ///< what was asked

  std::string table() const;  ///< a line for each method, then the recommendation
  void write_csv(const std::string& path) const;  ///< a row for each method
};

/// Runs each method on a world of its own. Errors are those of the joints' own rows at the poses
/// that a method has reached. The reference is the direct solver with exact positions, in shorter
/// and shorter steps until two runs agree; of a chaotic scene only its beginning has one. Gaps
/// of iterations may grow: what is recommended has met the wish in a run Wish::times as long, too.
/// \param make_world makes the scene, the same one each time
/// \throws std::invalid_argument for a scene that cannot be made or stepped at all
Comparison compare(const std::function<World()>& make_world, const Wish& wish = {});

/// A program of it: reads --seconds, --hz, --gap, --depth, --budget, --csv, and prints the table.
int compare_main(const std::function<World()>& make_world, int argc, const char* const* argv);

}  // namespace joints
/// @}
