// Groups of pairs of bodies that can be solved side by side: by graph colouring or by islands.
// Pure functions of body indices, independent of joints and blocks.
#pragma once

#include <optional>
#include <vector>

#include "engine/simd/body_pair.h"

/// \addtogroup world
/// @{
namespace joints {

/// Indices of pairs in groups. Groups are solved in order, the pairs of one group side by side.
using Groups = std::vector<std::vector<int>>;
/// Indices of pairs, one list per island.
using Islands = std::vector<std::vector<int>>;

/// `count` groups of one pair each, in order.
Groups one_by_one(int count);

/// First-fit graph colouring: each pair gets the least colour that no earlier pair with one of its
/// moving bodies has. \param moves for each body, whether it can move
std::vector<int> greedy_colours(const std::vector<BodyPair>& pairs, const std::vector<bool>& moves);
/// Groups of at most `width` pairs of one colour and one kind, in the order of the colours.
/// \param kinds for each pair; empty if all pairs are of one kind
Groups by_colour(const std::vector<int>& colours, int width, const std::vector<int>& kinds = {});

/// Connected components: pairs connected by bodies that move. Each keeps the order of the pairs.
Islands islands_of(const std::vector<BodyPair>& pairs, const std::vector<bool>& moves);
/// The first pair of every island, then the second of every one, and so on, in groups of `width`
/// islands, one island per lane. At width 1 this order hides latency: while there are several
/// islands, a pair does not depend on the one before it.
Groups interleaved(const Islands& islands, int width);
/// Sorts islands into sets that agree pair by pair in their kinds and in how bodies are connected.
std::vector<Islands> alike(const Islands& islands, const std::vector<BodyPair>& pairs,
                           const std::vector<int>& kinds);

/// Positions of bodies in columns: `width` bodies side by side, each in one lane of one column for
/// the whole iteration. A static body has one copy per island.
struct Columns {
  std::vector<int> bodies;     ///< the bodies of all columns, lane by lane; -1: unused lane
  std::vector<BodyPair> ends;  ///< for each group, the columns of its bodies 1 and its bodies 2
};

/// The columns of these groups; nothing if a body would need two places, or a place two bodies.
std::optional<Columns> columns_of(const Groups& groups, const Islands& islands,
                                  const std::vector<BodyPair>& pairs, int width);

}  // namespace joints
/// @}
