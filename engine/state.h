// Saving and restoring a world: what its next steps depend on, as plain numbers.
#pragma once

#include <array>
#include <vector>

#include "engine/world.h"

/// \addtogroup world
/// @{
namespace joints {

/// All that steps change in a world, and all that a program changes to steer it: after restore()
/// the next steps are the same to the bit, by the same solver with the same settings. It holds for
/// the bodies poses, velocities, forces and torques; for the joints accumulated impulses, counted
/// turns, live rows, limits and motors. It does not hold what a world is built of and set to:
/// masses, the joints' geometry and their other settings (beta, frequency, damping, `projected`),
/// gravity, max_displacement. Nor does it hold World::blocks: restore() leaves them empty.
///
/// No solver keeps anything in itself that later steps depend on. What DirectSolver needs of the
/// last step is in `memory`.
struct State {
  real last_h = 0;          ///< World::last_h [s]
  real acted = 0;           ///< Blocks::acting [s]
  SolverMemory memory;      ///< Blocks::memory
  std::vector<int> slots;   ///< of the bodies in their array
  std::vector<real> bodies;  ///< 19 for each: x, q (w, x, y, z), v, w, force, torque
  std::vector<std::array<int, 3>> shapes;  ///< of each joint: two slots, how many numbers it has
  std::vector<real> joints;  ///< the joints' numbers; infinite for a limit that is not there

  bool operator==(const State&) const = default;  ///< the same numbers
};

/// The state of a world between two steps.
State save(const World& world);

/// Sets a world back, or another one that was built in the same way, with the same bodies in the
/// same slots and joints of the same kinds in the same order. Ids and joints stay valid.
/// \throws std::invalid_argument for the state of a world of another shape, or for numbers that no
/// world can have; nothing has changed
void restore(World& world, const State& state);

}  // namespace joints
/// @}
