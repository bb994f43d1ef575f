// The order in which blocks are solved, which of them are solved side by side, and where the
// velocities of their bodies are stored meanwhile. Only numbers of bodies, no joints and no blocks.
#pragma once

#include <array>
#include <vector>

#include "engine/simd/body_pair.h"

/// \addtogroup world
/// @{
namespace joints {

/// The data of a block that determine its place in an order.
struct Member {
  BodyPair bodies;  ///< slots; -1: a body that does not move
  int kind : 9 = 0;      ///< only blocks of one kind are solved side by side
  int follows : 23 = 0;  ///< RowSettings::follows
  bool operator==(const Member&) const = default;  ///< the same in all of these
};

/// Groups of up to `width` blocks, one per lane, that are solved one group after the other. No two
/// blocks of a group have a moving body in common. The velocities of each body are in a record. In
/// place of static bodies there are records of zeros, one for each lane of a group or one for each
/// island, so that an overflow in one lane or island never reaches another.
struct LaneOrder {
  int width = 1;            ///< lanes of a group
  bool columns = false;     ///< `width` records side by side are a column: bodies keep their lanes
  std::vector<int> blocks;  ///< for each group its blocks, lane by lane; -1: none
  std::vector<int> bodies;  ///< for each record a slot; -1: zeros
  /// For each group the records of bodies 1 of its lanes, then of bodies 2; with columns only the
  /// column of all bodies 1 and that of all bodies 2.
  std::vector<int> ends;

  int groups() const { return int(blocks.size()) / width; }     ///< number of groups
  int ends_of_a_group() const { return columns ? 2 : 2 * width; }  ///< numbers in `ends`
  /// Removes all groups; record k belongs to body k. \param lanes the new width
  void clear(int lanes, int slots);
  /// Appends a group, without columns. \param lanes `width` blocks, or -1 for none
  void append(const int* lanes, const std::vector<Member>& members);
};

/// Appends the blocks from number `first` on in the order of the list, each as a separate group.
void append_in_turn(LaneOrder& order, const std::vector<Member>& members, int first);

/// Orders blocks by greedy graph colouring. Keeps its memory between calls.
class GreedyColours {
 public:
  /// Gives each block from number `first` on the lowest colour that no earlier block with one of
  /// its moving bodies has. Appends the blocks colour by colour, and within a colour kind by kind.
  void append(LaneOrder& order, const std::vector<Member>& members, int first);

 private:
  std::vector<std::vector<bool>> taken_;  // for each colour, the bodies that have it
  std::vector<std::array<int, 2>> sorted_;  // colour and kind, and number, of each block
  std::vector<int> lanes_;                // of one group
};

}  // namespace joints
/// @}
