// What the direct solver keeps from one step for the next one.
#pragma once

#include <vector>

#include "engine/matrix.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// The data of the direct solver in Blocks::memory, which is part of a world's state. The
/// corrections of an island are used only if it has the same rows again.
struct SolverMemory {
  std::vector<vec3> inertia;   ///< least moments that the step used, for each slot [kg m^2]
  std::vector<int> patterns;   ///< for each island a hash of its rows, and their number
  std::vector<real> last;      ///< of each row: the last correction of J V for the poses
  std::vector<real> expected;  ///< and as expected in the next one [unit of C per s]

  /// Reads it; numbers that make no sense are none. \param slots number of bodies
  void read(const std::vector<real>& from, int slots);
  void write(std::vector<real>& to) const;  ///< writes it
};

}  // namespace joints
/// @}
