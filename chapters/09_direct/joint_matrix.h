// The pattern of the matrix of the joints: which blocks it has and where their numbers are stored.
// It is computed anew only when it changes. Given, there is nothing to edit here.
#pragma once

#include <array>

#include "chapters/09_direct/direct.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// The data of a block on which the pattern depends.
struct BlockPattern {
  int rows = 0;        ///< number of its rows, 1 to 6
  int row = 0;         ///< where its rows begin in the right-hand side
  int body1 = -1;      ///< slot of body 1; -1 if the body is static
  int body2 = -1;      ///< slot of body 2; -1 if the body is static
  bool bounded = false;  ///< its last row has bounds
  bool operator==(const BlockPattern&) const = default;  ///< all members are equal
};

/// Inverse mass and inverse inertia (world axes) of a body; zeros if it is static.
struct BodyMass {
  double linear = 0;             ///< inverse mass [1/kg]
  Symmetric<double> angular{};   ///< inverse inertia [1/(kg m^2)]
};

/// The bodies and joints of a closed loop.
struct ClosedLoop {
  int bodies = 0;     ///< number of its moving bodies
  int rows = 0;       ///< number of the rows of its joints, without bounded rows
  bool held = false;  ///< whether one of its joints is attached to a static body
  /// Its degrees of freedom in the present pose, without those of the loop as a whole.
  /// \param dependent number of its rows that depend on others
  int motions(int dependent) const { return 6 * (bodies - !held) - rows + dependent; }
};

/// Makes the matrix of the joints. Two islands with the same pattern share it, one on each lane; if
/// an island has no partner, the other lane is idle. The pattern is computed anew only if it has
/// changed.
class JointMatrixMaker {
 public:
  JointMatrixOf<TwoLanes> A;  ///< the matrix

  /// Updates lanes, order, edges and targets. \return false if the pattern had not changed
  bool follow(const std::vector<BlockPattern>& blocks);
  /// Computes the numbers of A. \param J the half-rows of each block, from 2 * row() on: those of
  /// body 1, then those of body 2 \param masses of all bodies
  void assemble(const std::vector<HalfRowOf<TwoLanes>>& J, const std::vector<BodyMass>& masses);
  /// Length of the right-hand side; each of its elements holds both lanes.
  int rows() const { return int(A.original.size()); }
  /// The lane of a block. \param block its number in follow()
  int lane(int block) const { return at_[block].lane; }
  /// Where the rows of a block begin in the right-hand side.
  int row(int block) const { return A.nodes[node(block)].row; }
  /// Where the diagonal block of a block begins in A.numbers.
  int diagonal(int block) const { return A.nodes[node(block)].diagonal; }
  /// The closed loop that contains a block, as an index of loops(), or -1. A block that has only a
  /// bounded row closes no loop.
  int loop(int block) const { return loop_[block]; }
  const std::vector<ClosedLoop>& loops() const { return loops_; }  ///< all closed loops
  /// Number of multiplications of a factorisation, about (Eq. 9-6).
  double multiplications() const { return multiplications_; }
  /// Number of entries that elimination fills in.
  int fill() const { return fill_; }

 private:
  struct Place {  // where a block is: a lane of blocks_[pattern]
    int pattern, lane;
  };
  // The half of a block that belongs to a moving body. The body couples it with itself and with the
  // halves of other blocks.
  struct Half {
    int J, rows;     // where its half-rows begin, and their number
    int at;          // where the diagonal block begins
    int body[2];     // slots of the lanes' bodies; -1: the lane is idle
    int couplings;   // number of its couplings; they follow those of the previous half
  };
  struct Coupling {
    int J, rows;  // of the other half; its block is eliminated later
    int at;       // where the numbers of the block in A begin
  };
  int node(int block) const { return place_[at_[block].pattern]; }
  void find_loops();
  void place_islands();
  std::vector<std::vector<int>> neighbours_of() const;
  void place_blocks(const std::vector<int>& order);
  void place_targets();
  void place_couplings();
  int at(int later, int earlier) const;

  std::vector<BlockPattern> listed_;         // all blocks, as given
  std::vector<int> loop_;                    // of each block the index of its closed loop
  std::vector<ClosedLoop> loops_;
  std::vector<Place> at_;                    // of each block
  std::vector<BlockPattern> blocks_;         // the patterns, which are the blocks of lane 0
  std::vector<std::array<int, 2>> lanes_;    // for each pattern its listed blocks; -1: idle lane
  std::vector<std::vector<int>> blocks_of_;  // for each body the indices of its blocks
  std::vector<int> place_;                   // of each block in the order of elimination
  std::vector<Half> halves_;
  std::vector<Coupling> couplings_;
  double multiplications_ = 0;
  int fill_ = 0;
};

}  // namespace joints
/// @}
