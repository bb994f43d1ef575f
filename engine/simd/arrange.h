// Who is solved side by side, and when: colours, or islands. Pure functions over numbers of bodies,
// which know nothing of what a joint or a block is.
#pragma once

#include <optional>
#include <vector>

/// \addtogroup world
/// @{
namespace joints {

/// Which two bodies a joint or a block holds, by their numbers.
struct BodyPair {
  int body1 = 0;  ///< one of them
  int body2 = 0;  ///< the other
  bool operator==(const BodyPair&) const = default;  ///< the same bodies in the same roles
};

/// Pairs by their numbers, in groups that come one after the other; a group is solved side by side.
using Groups = std::vector<std::vector<int>>;
/// Pairs by their numbers, one list for each set of pairs that hangs together.
using Islands = std::vector<std::vector<int>>;

/// So many pairs, every one by itself, in their order.
Groups one_by_one(int count);

/// A colour for each pair: the least that no earlier pair at one of its moving bodies has.
/// \param moves of each body: can it move?
std::vector<int> greedy_colours(const std::vector<BodyPair>& pairs, const std::vector<bool>& moves);
/// Colour after colour, at most `width` pairs at a time. \param kinds of each pair: within a colour
/// only those of one kind come together; empty where all are alike
Groups by_colour(const std::vector<int>& colours, int width, const std::vector<int>& kinds = {});

/// Pairs that hang together by bodies that move, each island in the order of the pairs.
Islands islands_of(const std::vector<BodyPair>& pairs, const std::vector<bool>& moves);
/// The first pair of each island, then the second of each, and so on, an island a lane: `width`
/// islands at a time. With a width of 1 no pair has to wait for the one before.
Groups interleaved(const Islands& islands, int width);
/// Islands that are alike pair by pair: in their kinds, and in how their bodies hang together.
std::vector<Islands> alike(const Islands& islands, const std::vector<BodyPair>& pairs,
                           const std::vector<int>& kinds);

/// Where bodies stand if each keeps its lane: `width` of them side by side in a column. A static
/// body has a copy for every island.
struct Columns {
  std::vector<int> bodies;     ///< of each column, lane by lane; -1 where a lane has none
  std::vector<BodyPair> ends;  ///< of each group, the columns of its bodies 1 and of its bodies 2
};

/// The columns of some groups, or nothing where a body would have to change its lane.
std::optional<Columns> columns_of(const Groups& groups, const Islands& islands,
                                  const std::vector<BodyPair>& pairs, int width);

}  // namespace joints
/// @}
