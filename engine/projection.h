// Position projection: places and orientations are put right themselves, not by a velocity.
#pragma once

#include "engine/world.h"

/// \addtogroup world
/// @{
namespace joints {

/// Nonlinear Gauss-Seidel on the positions. An iteration visits every projected joint, asks it for
/// its blocks at the present poses, and moves its two bodies by M^-1 J^T K^-1 (-C), so that C is
/// zero to first order; velocities stay as they are. A one-sided row moves them only where it is
/// violated.
/// Source: the thesis, section 6; Catto, Position Correction Notes (in the source of Box2D 2), who
/// calls it nonlinear Gauss-Seidel.
class Projection {
 public:
  real longest_move = real(0.2);  ///< a block moves a centre no further than this in a visit [m]
  real widest_turn = real(0.2);   ///< nor does it turn a body by more [rad]

  /// One iteration over all joints whose `projected` is set. Allocates only when the world has
  /// grown.
  void iterate(World& world);

 private:
  void solve(Bodies& bodies, const Block& block, int rows);
  Blocks blocks_;  // of one joint at a time
};

}  // namespace joints
/// @}
