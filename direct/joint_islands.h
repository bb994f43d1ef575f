// The islands of the blocks, each a system of its own.
#pragma once

#include <map>
#include <memory>

#include "chapters/09_direct/joint_system.h"
#include "direct/closed_loops.h"
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
  bool operator==(const BlockPattern&) const = default;  ///< all members are equal
  /// True for a single bounded row, as of a limit or a motor: it may come and go.
  bool optional() const { return rows == 1 && bounded; }
};

/// The analysis of a shape.
struct ShapePlan : EliminationPlan, ClosedLoops {
  explicit ShapePlan(const std::vector<ShapeBlock>& shape)
      : EliminationPlan(shape), ClosedLoops(shape) {}  ///< analyses a shape
};

/// Blocks that moving bodies connect.
struct Island {
  JointSystem system;            ///< without blocks if the island is left to another solver
  std::vector<ShapeBlock> shape;  ///< empty for a hub
  std::shared_ptr<const ShapePlan> plan;  ///< of the shape; null for a hub
  std::vector<int> dependent;    ///< for each closed loop a number of rows (AddedInertia)
  int first = 0, end = 0;        ///< its blocks in JointIslands::order()
  int first_row = 0, rows = 0;   ///< its rows, island after island
  int root = 0;                  ///< JointIslands::root_of() its bodies
  int pattern = 0;               ///< a hash of its blocks
  bool left = false;             ///< to another solver
  bool is_new = true;            ///< its system was laid out in this step
  bool alternates = false;       ///< blocks without rows act on it: it is solved repeatedly
  bool active = false;           ///< it is solved now

  /// Calls f(slot) for all its bodies that can move.
  template <class F>
  void for_moving(const F& f) const {
    for (std::size_t k = 0; k < system.bodies.size(); ++k)
      if (system.moves[k]) f(system.bodies[k]);
  }
};

/// Groups blocks into islands, which are connected by moving bodies. Shapes are analysed once and
/// kept. If an optional row comes or goes, only the matrix of its island is laid out anew.
class JointIslands {
 public:
  /// Where a block is.
  struct Place {
    int island = -1;  ///< its island; -1 if it is in none
    int block = 0;    ///< its number in JointSystem::blocks
    int row = 0;      ///< its first row, counted island after island
  };

  std::vector<BlockPattern> given;  ///< all blocks; those without rows are in no island
  std::vector<Island> list;         ///< the islands, by their first blocks

  /// Updates the islands. \param changed false if `given` is that of the last call
  /// \param slots number of bodies \param most_work islands whose joints take more multiplications
  /// per row are left to another solver, and with them all islands that a block without rows
  /// connects to them
  void group(bool changed, int slots, double most_work);
  const std::vector<int>& order() const { return order_; }  ///< block numbers, island by island
  const Place& at(int block) const { return at_[block]; }   ///< of a block
  int rows() const { return rows_; }                        ///< of all islands
  int root_of(int body);  ///< one body of each island, for all of its moving bodies
  /// True if a block without rows acts on the island of a root, or on that body alone.
  bool is_beside(int root) const { return beside_[root]; }
  /// True if a block has rows, and its island is not left to another solver.
  bool in_matrix(int block) const {
    return at_[block].island >= 0 && !list[at_[block].island].left;
  }
  bool is_left(int block) { return left_[root_of_block(block)]; }  ///< to another solver

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
  void leave_hubs();
  void place_blocks(Island& island);

  double most_work_ = 0;
  std::vector<Key> keys_;
  std::vector<bool> left_, beside_;     // of each root
  std::vector<int> order_;
  std::vector<Place> at_;
  std::vector<int> root_, first_, column_, count_;  // of each body
  std::vector<ShapeBlock> shape_;       // of one island
  std::vector<int> bodies_, begins_;    // its bodies; where its links begin in the keys
  std::vector<SystemBlock> blocks_;     // of its system
  std::map<std::vector<ShapeBlock>, std::shared_ptr<const ShapePlan>> plans_;
  int rows_ = 0;
};

}  // namespace joints
/// @}
