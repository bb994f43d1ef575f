// Saving and restoring a world: all data on which its next steps depend, as plain numbers.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "engine/world.h"

/// \addtogroup world
/// @{
namespace joints {

/// All data of a world that steps change or that a program changes to control it. After restore()
/// the next steps are bit-identical, with the same solver and the same settings. For the bodies it
/// contains poses, velocities, forces and torques; for the joints accumulated impulses, counted
/// turns, live rows, limits and motors. It does not contain the construction and settings
/// of a world: masses, the geometry of the joints and their other settings (beta, frequency,
/// damping, `projected`), gravity, max_displacement. Nor does it contain World::blocks, which are
/// empty after restore(), or joints that are Joint::transient().
///
/// Solver objects hold no data on which later steps depend. The data that DirectSolver needs from
/// the last step is in `memory`.
struct State {
  real last_h = 0;          ///< World::last_h [s]
  real impulse_duration = 0;          ///< Blocks::impulse_duration [s]
  std::vector<real> memory;  ///< Blocks::memory
  std::vector<int> slots;   ///< of the bodies in their array
  std::vector<real> bodies;  ///< 19 for each: x, q (w, x, y, z), v, w, force, torque
  std::vector<std::array<int, 3>> shapes;  ///< for each joint two slots and its count of numbers
  std::vector<int> kinds;  ///< of the bodies (0 static, 1 kinematic, 2 moving), then of the joints
  std::vector<real> joints;  ///< the numbers of the joints; infinite for a limit that is not set

  bool operator==(const State&) const = default;  ///< the same numbers
};

/// The state of a world between two steps.
State save(const World& world);

/// Restores the state of a world, or of another world that was built in the same way, with the same
/// bodies in the same slots and joints of the same kinds in the same order. Ids and joints remain
/// valid. \throws std::invalid_argument for the state of a world with another structure, or for
/// numbers that no world can have; then nothing has changed
void restore(World& world, const State& state);

/// A state as bytes, to be written to a file or sent to another machine with the same processor and
/// a library of the same version.
std::string to_bytes(const State& state);

/// The state that to_bytes() has written. It fits only the world for which restore() accepts it.
/// \throws std::invalid_argument for bytes that are no state, for those of another version or of
/// another kind of number, for too few and too many
State from_bytes(std::string_view bytes);

}  // namespace joints
/// @}
