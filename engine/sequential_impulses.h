// Sequential Impulses (Catto 2006; Algorithm 1 of the thesis): the engine's own solver.
#pragma once

#include "engine/solver.h"

/// \addtogroup rows
/// @{
namespace joints {

/// The data of a row that the inner loop needs in addition to J.
struct PreparedRow {
  Row response;  ///< M^-1 J^T: the change of the velocities caused by an impulse of 1
  real bias;     ///< minus the required J V [unit of C per s]
  /// How much this row's impulse changes per unit by which clamping changes that of the block's
  /// last row: Kinv[i][last] / Kinv[last][last].
  real clamp_response;
};

/// A block with the data that the inner loop needs.
struct PreparedBlock : Block {
  int first_K;  ///< where its matrix begins in Prepared::scaled_inverse_K
  SoftCoefficients coefficients;  ///< its settings as scales and bounds
};

/// The prepared blocks of a step: bias, scales, bounds and the inverse of K, all for one h.
struct Prepared {
  std::vector<PreparedBlock> blocks;  ///< in the order of Blocks::list
  std::vector<PreparedRow> rows;      ///< one for each row, as in Blocks::C
  std::vector<real> scaled_inverse_K;  ///< mass_scale K^-1, rows x rows numbers per block
};

/// @}
/// \addtogroup world
/// @{

/// Sequential Impulses, that is, projected block Gauss-Seidel on the impulses. Each iteration
/// solves every block for the present velocities, exactly if its rows are hard and relaxation is 1,
/// in the order of the list. Source: Catto,
/// "Fast and Simple Physics using Sequential Impulses", GDC 2006.
class SequentialImpulses : public IterativeSolver {
 public:
  /// Prepares blocks. \throws std::invalid_argument if a bound follows an impulse without a row
  void prepare(const Bodies& bodies, const Blocks& blocks, int first_block, real h) override;
  /// As Solver::warm_start(); also sets the impulse of a row to zero if its Jacobian is zero or if
  /// it depends on other rows of its block.
  void warm_start(Bodies& bodies, real ratio) override;
  void solve(Bodies& bodies) override;

  // Parts of solve(), for measurements between iterations or for another order.

  /// One iteration over all prepared blocks.
  void iterate(Bodies& bodies);
  /// One iteration over the prepared blocks [from, to).
  /// \throws std::invalid_argument unless 0 <= from and to <= prepared_count()
  void iterate(Bodies& bodies, int from, int to);
  /// The number of prepared blocks.
  int prepared_count() const { return int(prepared_.blocks.size()); }

 protected:
  Prepared prepared_;  ///< all blocks of the step so far

 private:
  void add(const Bodies& bodies, const Blocks& blocks, const Block& block, real h);
  template <int N>
  void solve_block(Body* bodies, const Row* J, const PreparedBlock& block);
};

}  // namespace joints
/// @}
