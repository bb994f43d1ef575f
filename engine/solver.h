// What a solver is: it finds the impulses of a step's blocks. It sees bodies and blocks, no joint.
#pragma once

#include "engine/block.h"

/// \addtogroup world
/// @{
namespace joints {

/// Finds impulses that give every row the velocity it wants, within its bounds, and applies them to
/// the bodies. The step calls check, prepare, warm_start and solve in this order; after late limits
/// have added blocks, prepare and solve once more. A new kind of solver is one class in one file.
class Solver {
 public:
  virtual ~Solver() = default;
  /// \throws std::invalid_argument for settings without sense, before anything has moved
  virtual void check() const = 0;
  /// Works out what the solve needs to know of the blocks from number `first` on; those before it
  /// stay as they are. \param h step [s]
  virtual void prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) = 0;
  /// Begins with the impulses of the last step times `ratio`, applied to the bodies.
  /// \param ratio this step over the last one [1]; 0 for a cold start, which sets them to zero
  virtual void warm_start(Bodies& bodies, real ratio) = 0;
  /// Changes velocities and impulses until the rows hold, as well as this solver can.
  virtual void solve(Bodies& bodies) = 0;
};

}  // namespace joints
/// @}
