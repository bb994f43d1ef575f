// The matrix of a pair of islands: where its numbers are stored, and how it is assembled. Given,
// there is nothing to edit here.
#pragma once

#include <memory>
#include <utility>

#include "chapters/09_direct/direct.h"
#include "chapters/09_direct/elimination_plan.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// A block of up to two islands, one on each lane.
struct LaneBlock {
  int place = 0;                  ///< that of its link in the order of elimination
  int loop = -1;                  ///< its closed loop, or -1
  std::array<int, 2> columns{};   ///< of its bodies
  int rows = 0;                   ///< 1 to 6, the larger number of both lanes
  bool bounded = false;           ///< the last row has bounds on a lane
  Form form = Form::any;          ///< of its rows on both lanes
  std::array<int, 2> block{-1, -1};  ///< numbers of its two blocks; -1: the lane is idle
  std::array<int, 2> own{};       ///< their numbers of rows; 0 if the lane is idle
  std::array<int, 2> row{};       ///< their first rows, counted island after island
  int node = 0;                   ///< its node in the matrix
  int first = 0;                  ///< its first row in that node
  int lanes() const { return (own[0] > 0) + (own[1] > 0); }  ///< that are not idle
  /// True if the matrix has the same pattern with the other block in its place.
  bool like(const LaneBlock& other) const {
    return place == other.place && loop == other.loop && columns == other.columns &&
           own == other.own && bounded == other.bounded && form == other.form;
  }
};

/// Largest number of rows of a node. While they are not more, the blocks of a link share a node, as
/// those of a hinge and its motor do.
constexpr int most_rows = 6;

/// The bodies and the form of a node.
struct LaneNode {
  std::array<int, 2> columns{};   ///< of its bodies
  Form form = Form::any;          ///< of its rows on both lanes
  int lanes = 0;                  ///< that are not idle
};

/// The matrix of the joints of two islands with the same shape, one on each lane.
class IslandMatrix {
 public:
  JointMatrixOf<TwoLanes> A;  ///< the matrix
  std::vector<LaneNode> nodes;  ///< of A
  std::shared_ptr<const EliminationPlan> plan;  ///< of both islands
  std::vector<LaneBlock> blocks;                ///< of both islands, in the order of elimination
  std::vector<bool> moves;        ///< for each column whether its bodies move
  std::vector<InverseMassOf<TwoLanes>> masses;  ///< for each column
  /// The half-rows of node k, from 2 * A.nodes[k].row on: those of body 1, then those of body 2.
  std::vector<HalfRowOf<TwoLanes>> J;

  /// Puts the blocks into nodes, and computes edges, targets and couplings from plan and moves. All
  /// J become zero, or the unit vectors of a point.
  void lay_out();
  /// Takes memory for twice as many rows and nodes, so that bounded rows may come and go.
  void make_room();
  /// Computes the numbers of A from J and masses.
  void assemble();
  /// Number of multiplications of a factorisation, about (Eq. 9-6).
  double multiplications() const { return multiplications_; }
  int rows() const { return rows_; }  ///< of both islands
  /// Where the numbers of a block begin in the right-hand side.
  int row_of(const LaneBlock& block) const { return A.nodes[block.node].row + block.first; }
  /// Number of entries that elimination fills in.
  int fill() const { return fill_; }

 protected:
  /// The half-rows of a block at body 1, or at body 2. \param of 0 or 1
  HalfRowOf<TwoLanes>* half(const LaneBlock& block, int of) {
    const Node& node = A.nodes[block.node];
    return &J[2 * node.row + of * node.rows + block.first];
  }
  /// Index in A.numbers of the diagonal entry of row i of a block.
  int diagonal(const LaneBlock& block, int i) const {
    const Node& node = A.nodes[block.node];
    return node.diagonal + (block.first + i) * (node.rows + 1);
  }

 private:
  // A half of a node and another one at the same body, which is eliminated later.
  struct Coupling {
    int J, rows;   // where the half-rows of the other one begin, and their number
    int at;        // where the block of the two begins in A
    bool any;      // the linear parts of a half have any form
    double units;  // 1 or -1, the product of their unit vectors if both are those of points; else 0
  };
  void make_nodes();
  void place_couplings();
  int at(int later, int earlier) const;

  std::vector<int> first_;  // node of each link, in the order of elimination
  std::vector<Coupling> couplings_;  // of all halves; the first one of a half is with itself
  std::vector<int> couplings_end_;   // of each half, two for each node
  double multiplications_ = 0;
  int fill_ = 0, rows_ = 0;
};

}  // namespace joints
/// @}
