// The islands of the blocks, and their places on two lanes. Given, there is nothing to edit here.
#pragma once

#include <map>
#include <span>

#include "chapters/09_direct/island_pair.h"
#include "engine/simd/body_pair.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// The data of a block on which the pattern of the matrix depends.
struct BlockPattern {
  BodyPair bodies;               ///< slots
  std::array<bool, 2> moves{};   ///< whether they can move
  int rows = 0;                  ///< 1 to 6
  bool bounded = false;          ///< its last row has bounds
  Form form = Form::any;         ///< of its rows
  bool operator==(const BlockPattern&) const = default;  ///< all members are equal
  /// True for a single bounded row, as of a limit or a motor: it may come and go.
  bool optional() const { return rows == 1 && bounded; }
};

/// Groups blocks into islands, which are connected by moving bodies, and puts islands of the same
/// shape on two lanes. Shapes are analysed once and kept. If an optional row comes or goes, only
/// the list of its pair of islands changes.
class JointIslands {
 public:
  std::vector<IslandPair> pairs;  ///< of all islands but those that are left
  /// An island.
  struct Island {
    int first = 0, end = 0;        ///< its blocks in order()
    int first_row = 0, rows = 0;   ///< its rows, island after island
    int pair = -1, lane = 0;       ///< -1: it is left to another solver
    int root = 0;                  ///< root_of() its bodies
    int pattern = 0;               ///< a hash of its blocks
    int first_link = 0, first_column = 0;  ///< where its links and its columns begin
  };
  /// Where a block is.
  struct Place {
    int island = -1;  ///< its island; -1 if it is in none
    int block = 0;    ///< its number in IslandPair::blocks
    int row = 0;      ///< its first row, counted island after island
  };

  std::vector<BlockPattern> given;  ///< all blocks; those without rows are in no island

  /// Updates islands and pairs. \param changed false if `given` is that of the last call
  /// \param slots number of bodies \param most_work islands whose joints take more multiplications
  /// per row are left to another solver, and with them all islands that a block without rows
  /// connects to them
  void group(bool changed, int slots, double most_work);
  const std::vector<Island>& islands() const { return islands_; }  ///< by their first blocks
  const std::vector<int>& order() const { return order_; }  ///< block numbers, island by island
  const Place& at(int block) const { return at_[block]; }   ///< of a block
  int rows() const { return rows_; }                        ///< of all islands
  int root_of(int body);  ///< one body of each island, for all of its moving bodies
  /// True if a block without rows acts on the island of a root, or on that body alone.
  bool is_beside(int root) const { return beside_[root]; }
  /// True if a block has rows, and its island is not left to another solver.
  bool in_matrix(int block) const {
    return at_[block].island >= 0 && islands_[at_[block].island].pair >= 0;
  }
  bool is_left(int block) { return left_[root_of_block(block)]; }  ///< to another solver
  /// The pair of an island; null if it is left to another solver.
  IslandPair* pair_of(int island) {
    return islands_[island].pair < 0 ? nullptr : &pairs[islands_[island].pair];
  }

 private:
  struct Key {  // sorts blocks by island and link; in a link optional rows come last
    int island, link;
    bool optional;
    int block;
    auto operator<=>(const Key&) const = default;
  };
  int root_of_block(int block) {
    return root_of(given[block].moves[0] ? given[block].bodies.body1 : given[block].bodies.body2);
  }
  void find_islands(int slots);
  void find_shapes();
  bool is_hub(const Island& island) const;
  void find_plans();
  void leave_hubs();
  void pair_islands();
  void place_blocks(IslandPair& pair);
  std::span<const ShapeBlock> shape(int island) const {
    return std::span(shape_).subspan(begins_[island], begins_[island + 1] - begins_[island]);
  }

  double most_work_ = 0;
  std::vector<Key> keys_;
  std::vector<Island> islands_;
  std::vector<ShapeBlock> shape_, last_shape_;  // of all islands
  std::vector<int> begins_, last_begins_;       // of the shapes of the islands
  std::vector<std::shared_ptr<const EliminationPlan>> plan_;  // of each island; null for a hub
  std::vector<bool> left_, last_left_;          // of each root: its island is left
  std::vector<bool> beside_;                    // of each root
  std::vector<int> order_, links_, by_shape_;   // links_: where links begin in the keys
  std::vector<int> columns_;                    // of all islands: the bodies of their columns
  std::vector<Place> at_;
  std::vector<int> root_, first_, column_, count_;  // of each body
  std::vector<LaneBlock> blocks_;
  std::map<std::vector<ShapeBlock>, std::shared_ptr<const EliminationPlan>> plans_;
  int rows_ = 0;
};

}  // namespace joints
/// @}
