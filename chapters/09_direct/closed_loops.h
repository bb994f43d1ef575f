// Which joints are in closed loops: only there can rows depend on others. Given, there is nothing
// to edit here.
#pragma once

#include <vector>

#include "engine/simd/body_pair.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// For each joint the number of the closed loop in which it is, or -1 for a joint that alone
/// connects what is on its two sides. Loops that share more than one body are one (the biconnected
/// components of the graph of bodies and joints). \param joints of two different bodies each
/// \param bodies how many there are; everything static counts as one body
std::vector<int> closed_loops(const std::vector<BodyPair>& joints, int bodies);

}  // namespace joints
/// @}
