// What the inner loop of a solver needs to know of the blocks: worked out once a step.
#pragma once

#include "engine/block.h"

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
  signed char follows;  ///< RowTarget::follows: then `upper` is a factor, and there is no `lower`
  real mass_scale, impulse_scale;  ///< soft rows; 1 and 0 for hard ones
  real lower, upper;       ///< bounds of the last row's sum, as impulses [N s or N m s]
  real* impulse;           ///< its sums, in the joint
  int followed = -1;       ///< follows: the number of the row that has the other sum
};

/// The blocks of a step, prepared: each target turned, with this h, into bias, scales, bounds and
/// the inverse of K.
class Preparation {
 public:
  std::vector<PreparedBlock> blocks;  ///< in the order of the list
  std::vector<PreparedRow> rows;      ///< of all of them, one for each of Blocks::J
  std::vector<real> inverse_K;        ///< rows x rows numbers a block
  real relaxation = 1;                ///< factor of every impulse [1]: over-relaxation above 1

  /// Forgets all, and makes room for so many rows.
  void clear(int most_rows);
  /// Prepares the blocks of the list from number `first` on.
  /// \param row_by_row every row as a block of its own
  void add(const Bodies& bodies, const Blocks& blocks, int first, real h, bool row_by_row);
  /// The warm start: applies the impulses of the last step times `ratio`; 0 makes them zero. A row
  /// that can do nothing now (no direction, or dependent on others) loses its impulse, too.
  void start(Bodies& bodies, const Blocks& blocks, real ratio);

 private:
  void add_rows(const Bodies& bodies, const Blocks& list, const Block& block, int from, int to,
                real h);
  int followed_row(std::size_t k) const;
};

}  // namespace joints
/// @}
