// In which order blocks are solved, which of them side by side, and where the velocities of their
// bodies stand meanwhile. Knows numbers of bodies, but neither joints nor blocks.
#pragma once

#include <vector>

#include "engine/simd/body_pair.h"

/// \addtogroup world
/// @{
namespace joints {

/// What the place of a block in an order depends on.
struct Member {
  BodyPair bodies;  ///< slots; -1: a body that does not move
  int kind = 0;     ///< only blocks of one kind are solved side by side
  bool operator==(const Member&) const = default;  ///< the same bodies and the same kind
};

/// Groups of up to `width` blocks, one a lane, that are solved one group after the other. No two
/// blocks of a group share a body that moves. The velocities of each body stand in a record. What
/// does not move has a record of zeros in its place, one for each lane of a group or one for each
/// island: what overflows in one never reaches another.
struct LaneOrder {
  int width = 1;            ///< lanes of a group
  bool columns = false;     ///< `width` records side by side are a column: bodies keep their lanes
  std::vector<int> blocks;  ///< of each group, lane by lane; -1: none
  std::vector<int> bodies;  ///< of each record, a slot; -1: zeros
  /// Of each group the records of its lanes' bodies 1, then of their bodies 2; with columns only
  /// the column of all bodies 1 and that of all bodies 2.
  std::vector<int> ends;

  int groups() const { return int(blocks.size()) / width; }     ///< how many
  int ends_of_a_group() const { return columns ? 2 : 2 * width; }  ///< numbers in `ends`
  /// Begins anew: no groups, and record k belongs to body k. \param lanes the new width
  void clear(int lanes, int slots);
  /// Appends a group, without columns. \param lanes `width` blocks, or -1 for none
  void append(const int* lanes, const std::vector<Member>& members);
};

/// Appends the blocks from number `first` on in the order of the list, each in a group of its own.
void append_in_turn(LaneOrder& order, const std::vector<Member>& members, int first);

/// Orders by greedy graph colouring. Keeps its memory from one to the next.
class GreedyColours {
 public:
  /// Gives each block from number `first` on the least colour that none before it with one of its
  /// moving bodies has, and appends them colour by colour, within a colour kind by kind.
  void append(LaneOrder& order, const std::vector<Member>& members, int first);

 private:
  std::vector<std::vector<bool>> taken_;  // for each body, its colours
  std::vector<int> colours_;              // for each block
  std::vector<int> sorted_;               // blocks by colour and kind
  std::vector<int> lanes_;                // of one group
};

}  // namespace joints
/// @}
