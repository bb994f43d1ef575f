// Which numbers the matrix of the joints has and where they stand: the pattern, made when it
// changes and then kept. Given, there is nothing to edit here.
#pragma once

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
  bool operator==(const BlockPattern&) const = default;  ///< the same in all
};

/// Two blocks, or a block and itself, that share a moving body: add_coupling() at this place.
struct Coupling {
  int later, earlier;            ///< where their half-rows at the body begin
  int rows_later, rows_earlier;  ///< how many
  int at;                        ///< where the numbers begin
};

/// Makes the matrix of the joints, and makes it anew only if the pattern has changed.
class JointMatrixMaker {
 public:
  JointMatrix A;  ///< the matrix

  /// Brings order, edges and targets up to date. \param rows length of the right-hand side
  /// \return false if nothing had to be done
  bool follow(const std::vector<BlockPattern>& blocks, int rows);
  /// Fills in the numbers. \param J both half-rows of every row: block by block those of body 1,
  /// then those of body 2, from 2 * BlockPattern::row on \param response the same of M^-1 J^T
  void assemble(const std::vector<HalfRow>& J, const std::vector<HalfRow>& response);
  /// Where the diagonal block of a block begins. \param block its number in the pattern
  int diagonal(int block) const { return A.nodes[place_[block]].diagonal; }
  /// How many multiplications a factorisation takes: what tells if it is worth it.
  double multiplications() const { return multiplications_; }
  /// How many numbers elimination fills in where A itself has none.
  int fill() const { return fill_; }

 private:
  std::vector<std::vector<int>> neighbours_of() const;
  void place_blocks(const std::vector<int>& order);
  void place_targets();
  void place_couplings();
  int at(int later, int earlier) const;

  std::vector<BlockPattern> blocks_;
  std::vector<std::vector<int>> blocks_of_;  // of each body, as numbers of blocks
  std::vector<int> place_;                   // of each block, in the order of elimination
  std::vector<Coupling> couplings_;
  double multiplications_ = 0;
  int fill_ = 0;
};

}  // namespace joints
/// @}
