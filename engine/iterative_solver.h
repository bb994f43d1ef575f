// What solvers share that go over the blocks again and again: their preparation, once a step.
#pragma once

#include "engine/solver.h"

/// \addtogroup rows
/// @{
namespace joints {

/// What the inner loop reads of a row beside J: the bias and the angular half of M^-1 J^T.
struct PreparedRow {
  real bias;          ///< wanted J V, with its sign turned [unit of C per s]
  real answer;        ///< Kinv[i][last] / Kinv[last][last]
  vec3 turn1, turn2;  ///< I1^-1 J_w1^T, I2^-1 J_w2^T: the angular half of M^-1 J^T
};

/// What the inner loop reads of a block.
struct PreparedBlock {
  int body1, body2;        ///< slots
  int rows;                ///< 1 to 6
  int first, first_K;      ///< where its rows and its inverse begin: Blocks::J, rows, inverse_K
  Touches touches;         ///< which half of the velocities it needs
  signed char follows;     ///< RowTarget::follows: if not 0, `upper` is a factor, `lower` not read
  real mass_scale, impulse_scale;  ///< soft rows; 1 and 0 for hard ones
  real lower, upper;       ///< bounds of the last row's impulse [N s or N m s]
  real* impulse;           ///< the accumulated impulses, in the joint
  int followed = -1;       ///< follows: the number of the row that has the other impulse
};

/// The blocks of a step, prepared: each target turned, with this h, into bias, scales, bounds and
/// the inverse of K.
struct Prepared {
  std::vector<PreparedBlock> blocks;  ///< in the order of the list
  std::vector<PreparedRow> rows;      ///< of all of them, one for each of Blocks::J
  std::vector<real> inverse_K;        ///< rows x rows numbers a block
};

/// @}
/// \addtogroup world
/// @{

/// A solver that solves each block while the others wait, again and again. What it does not say is
/// in which order, and in which form it keeps what it reads: solve().
class IterativeSolver : public Solver {
 public:
  int iterations = 30;  ///< over all blocks, in a solve
  real relaxation = 1;  ///< over-relaxation: a factor of every impulse [1], below 2

  void check() const override;
  /// \throws std::invalid_argument where a row's bound follows a row that is not there
  void prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) override;
  /// A row that can do nothing now (no direction, or dependent on others) loses its impulse.
  void warm_start(Bodies& bodies, real ratio) override;

 protected:
  Prepared prepared_;  ///< all blocks of the step so far
  /// The blocks of the last prepare(). \throws std::logic_error if these bodies are not those that
  /// it was called with, or if blocks have come or gone since
  const Blocks& blocks_of(const Bodies& bodies) const;

 private:
  virtual bool rows_apart() const { return false; }  // every row as a block of its own
  void add(const Bodies& bodies, const Block& block, int from, int to, real h);
  int followed_row(std::size_t k) const;

  const Bodies* bodies_ = nullptr;
  const Blocks* blocks_ = nullptr;
};

}  // namespace joints
/// @}
