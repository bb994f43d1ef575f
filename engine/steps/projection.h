// Position projection: corrects positions and orientations directly, without changing velocities.
#pragma once

#include "engine/world.h"

/// \addtogroup world
/// @{
namespace joints {

/// The largest rotation of a body by one block in one iteration [rad].
constexpr real max_rotation = real(0.2);

/// One iteration of nonlinear Gauss-Seidel on the positions. Each joint whose `projected` is set
/// appends its blocks at the present poses, and each block moves its bodies by M^-1 J^T K^-1 (-C).
/// Then C is zero to first order, unless World::max_displacement or max_rotation has shortened the
/// move. Velocities do not change. A one-sided row is included only if it is violated, and a soft
/// block never is. Source: the thesis, section 6; Catto, Position Correction Notes (in the source
/// of Box2D 2), where it is called nonlinear Gauss-Seidel.
///
/// Energy is not conserved. Usually some is lost, but linkages whose rows depend on each other may
/// gain some. In 10 s with a cold start, no feedback and four iterations a step, 9 of 80 Bricard
/// linkages drawn by seeds gained more than 1 % of their weight times the length of a rod, the
/// worst 54 %. Without projection none of them did, and with it none of 60 other linkages.
void project_positions(World& world);

}  // namespace joints
/// @}
