// Finds the joints that are in closed loops: only there can rows depend on others. Given, there is
// nothing to edit here.
#pragma once

#include <vector>

#include "engine/simd/body_pair.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// For each joint the number of the closed loop that contains it, or -1 if it is in no loop. Loops
/// that share more than one body count as one loop (the biconnected components of the graph of
/// bodies and joints). \param joints the two bodies of each joint, which must be different
/// \param bodies number of bodies; everything static counts as one body
std::vector<int> closed_loops(const std::vector<BodyPair>& joints, int bodies);

}  // namespace joints
/// @}
