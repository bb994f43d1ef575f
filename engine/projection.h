// Position projection: places and orientations are put right themselves, not by a velocity.
#pragma once

#include "engine/world.h"

/// \addtogroup world
/// @{
namespace joints {

/// In one projection a block moves the centre of a body no further than this [m].
constexpr real longest_move = real(0.2);
/// Nor does it turn a body by more [rad].
constexpr real widest_turn = real(0.2);

/// One iteration of nonlinear Gauss-Seidel on the positions. Every joint whose `projected` is set
/// is asked for its blocks at the present poses, and its two bodies are moved by M^-1 J^T K^-1 (-C)
/// so that C is zero to first order; velocities stay as they are. A one-sided row moves them only
/// where it is violated. Source: the thesis, section 6; Catto, Position Correction Notes (in the
/// source of Box2D 2), who calls it nonlinear Gauss-Seidel.
void project_positions(World& world);

}  // namespace joints
/// @}
