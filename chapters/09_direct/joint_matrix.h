// Which numbers the matrix of the joints has and where they stand: the pattern, made when it
// changes and then kept. Given, there is nothing to edit here.
#pragma once

#include <array>

#include "chapters/09_direct/direct.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// What the pattern depends on: how many rows a block has and which of its bodies move.
struct BlockPattern {
  int rows = 0;        ///< 1 to 6
  int row = 0;         ///< where its rows begin in the right-hand side
  int body1 = -1;      ///< slot; -1 if it does not move
  int body2 = -1;      ///< slot; -1 if it does not move
  bool bounded = false;  ///< its last row has bounds
  bool operator==(const BlockPattern&) const = default;  ///< the same in all
};

/// What a body resists with: inverse mass and inverse inertia (world); zeros if it does not move.
struct BodyMass {
  double linear = 0;             ///< [1/kg]
  Symmetric<double> angular{};   ///< [1/(kg m^2)]
};

/// Joints that close loops with each other.
struct ClosedLoop {
  int bodies = 0;     ///< how many of them move
  int rows = 0;       ///< of its joints, without bounded ones
  bool held = false;  ///< something in it does not move
  /// In how many ways it can move as it is, if so many of its rows depend on others.
  int motions(int dependent) const { return 6 * (bodies - !held) - rows + dependent; }
};

/// The matrix of the joints, of two islands of one pattern side by side on lanes. It is made anew
/// only if the pattern has changed. An island that has no equal leaves the other lane idle.
class JointMatrixMaker {
 public:
  JointMatrixOf<TwoLanes> A;  ///< the matrix

  /// Brings lanes, order, edges and targets up to date. \return false if nothing had to be done
  bool follow(const std::vector<BlockPattern>& blocks);
  /// Fills in the numbers. \param J both half-rows of every row: block by block those of body 1,
  /// then those of body 2, from 2 * row() on \param masses of all bodies
  void assemble(const std::vector<HalfRowOf<TwoLanes>>& J, const std::vector<BodyMass>& masses);
  /// Length of the right-hand side, of both lanes.
  int rows() const { return int(A.original.size()); }
  /// The lane of a block. \param block its number in follow()
  int lane(int block) const { return at_[block].lane; }
  /// Where the rows of a block begin in the right-hand side.
  int row(int block) const { return A.nodes[node(block)].row; }
  /// Where the diagonal block of a block begins.
  int diagonal(int block) const { return A.nodes[node(block)].diagonal; }
  /// The closed loop in which a block is, a number of loops(); -1: it is in none. A block that is a
  /// bounded row alone closes none.
  int loop(int block) const { return loop_[block]; }
  const std::vector<ClosedLoop>& loops() const { return loops_; }  ///< all closed loops
  /// How many multiplications a factorisation takes: what tells if it is worth it.
  double multiplications() const { return multiplications_; }
  /// How many numbers elimination fills in where A itself has none.
  int fill() const { return fill_; }

 private:
  struct Place {  // of a block: blocks_[pattern] in one of its lanes
    int pattern, lane;
  };
  // The half of a block at a moving body. There it is coupled with itself and with other halves.
  struct Half {
    int J, rows;     // where its half-rows begin, and how many
    int at;          // where the block's diagonal begins
    int body[2];     // slots of the lanes' bodies; -1: the lane is idle
    int couplings;   // how many, behind those of the half before
  };
  struct Coupling {
    int J, rows;  // of the other half, whose block is eliminated later
    int at;       // where the numbers begin
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
  std::vector<int> loop_;                    // of each
  std::vector<ClosedLoop> loops_;
  std::vector<Place> at_;                    // of each
  std::vector<BlockPattern> blocks_;         // those of lane 0: the patterns
  std::vector<std::array<int, 2>> lanes_;    // of each pattern the listed blocks; -1: idle
  std::vector<std::vector<int>> blocks_of_;  // of each body, as numbers of blocks
  std::vector<int> place_;                   // of each block, in the order of elimination
  std::vector<Half> halves_;
  std::vector<Coupling> couplings_;
  double multiplications_ = 0;
  int fill_ = 0;
};

}  // namespace joints
/// @}
