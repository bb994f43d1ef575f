// Islands on lanes: every body has a place that it keeps while contacts and limits come and go, and
// blocks are aligned with those of other islands.
#pragma once

#include <cstdint>

#include "engine/simd/lane_order.h"

/// \addtogroup world
/// @{
namespace joints {

/// An island is what joints and contacts connect, apart from what does not move. Up to `width`
/// islands, as like each other as there are, share columns: an island has one lane of all of them,
/// and each of its bodies has one of the columns. Blocks of several islands come side by side if
/// they are of one kind and between the same columns. Within an island the list's order stays.
class Places {
 public:
  /// Gives every body that moves a place, anew only if the links or what moves have changed.
  /// \param moves for each slot \return true if the places are new
  bool place(const std::vector<Member>& members, const std::vector<bool>& moves, int width);
  /// For each island of n bodies the first n - 1 blocks that connect them, as if of one kind. Other
  /// blocks, such as contacts with the ground and limits, change no place.
  const std::vector<Member>& links() const { return links_; }
  /// The blocks from number `first` on become the groups of an order, behind those it has. With
  /// `first` 0 it begins anew.
  void append(LaneOrder& order, const std::vector<Member>& members, int first);

 private:
  struct Island {
    int size = 0;             // bodies
    std::uint64_t shape = 0;  // a hash of which column was connected with which, in turn
    int root = 0;             // its first body
  };
  struct Place {
    int island = -1;  // -1: the body has none
    int column = -1;  // first within the island, then of all
  };
  struct Group {  // of a list of those that share columns
    BodyPair columns;
    int kind, next;
  };
  int root_of(int body);
  bool find_links(const std::vector<Member>& members);
  int width_ = 0, columns_ = 0;
  std::vector<Member> links_;
  std::vector<bool> moves_;
  std::vector<Place> places_;        // of each body
  std::vector<Island> islands_;      // `width` of them, one after the other, share columns
  std::vector<int> first_column_;    // of each share; the first one is left to what does not move
  // while bodies are placed
  std::vector<int> root_, number_;   // of each body: towards its island's root; of a root: island
  // while blocks are aligned
  std::vector<Group> groups_;
  std::vector<int> lanes_;           // of the groups, as LaneOrder::blocks
  std::vector<int> begin_, last_;    // of each share its first group; of each island its last one
};

}  // namespace joints
/// @}
