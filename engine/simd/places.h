// Islands on lanes: a body keeps its place while contacts and limits come and go, and blocks are
// aligned with those of other islands.
#pragma once

#include <cstdint>

#include "engine/simd/lane_order.h"

/// \addtogroup world
/// @{
namespace joints {

/// An island consists of the moving bodies that joints and contacts connect. Up to `width` islands
/// that are as similar as possible form a batch and share columns: each island has one lane of all
/// these columns, and each of its bodies has one of the columns. Blocks of several islands are
/// solved side by side if they are of one kind and between the same columns. Within an island the
/// blocks keep the order of the list.
class Places {
 public:
  /// Gives every moving body a place. The places change only if the links or the set of moving
  /// bodies has changed. \param moves for each slot \return true if the places are new
  bool place(const std::vector<Member>& members, const std::vector<bool>& moves, int width);
  /// For each island of n bodies the bodies of the first n - 1 blocks that connect them. Other
  /// blocks, such as contacts with the ground and limits, do not affect the places.
  const std::vector<BodyPair>& links() const { return links_; }
  /// Appends groups of the blocks from number `first` on to an order. With `first` 0 it replaces
  /// the groups of the order.
  void append(LaneOrder& order, const std::vector<Member>& members, int first);
  /// Gives back the memory that only append() needs.
  void release();

 private:
  struct Island {
    int size = 0;             // bodies
    std::uint64_t shape = 0;  // a hash of the connected columns, in sequence
    int root = 0;             // its first body
  };
  struct Place {
    int island = -1;  // -1: the body has none
    int column = -1;  // first within the island, then of all
  };
  struct Group {  // in the list of its batch
    BodyPair columns;
    int kind, next;
  };
  int root_of(int body);
  bool find_links(const std::vector<Member>& members);
  int width_ = 0, columns_ = 0;
  std::vector<BodyPair> links_;
  std::vector<bool> moves_;
  std::vector<Place> places_;        // of each body
  std::vector<Island> islands_;      // each `width` in sequence are a batch
  std::vector<int> first_column_;    // of each batch; static bodies have this column
  // while bodies are placed
  std::vector<int> root_, number_;   // of each body: towards its island's root; of a root: island
  // while blocks are aligned
  std::vector<Group> groups_;
  std::vector<int> lanes_;           // of the groups, as LaneOrder::blocks
  std::vector<int> begin_, last_;    // of each batch its first group; of each island its last one
};

}  // namespace joints
/// @}
