// Islands: joints that are connected through moving bodies. Pure functions of body indices,
// independent of joints and blocks.
#pragma once

#include <vector>

#include "engine/simd/body_pair.h"

/// \addtogroup world
/// @{
namespace joints {

/// Indices of pairs, one list per island.
using Islands = std::vector<std::vector<int>>;

/// Connected components: pairs connected by bodies that move. Each keeps the order of the pairs.
/// \param moves for each body, whether it can move
Islands islands_of(const std::vector<BodyPair>& pairs, const std::vector<bool>& moves);
/// Sorts islands into sets that agree pair by pair in kind and in the connected bodies.
std::vector<Islands> alike(const Islands& islands, const std::vector<BodyPair>& pairs,
                           const std::vector<int>& kinds);

}  // namespace joints
/// @}
