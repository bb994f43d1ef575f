// Sequential Impulses (Catto 2006; Algorithm 1 of the thesis): the engine's own solver.
#pragma once

#include "engine/iterative_solver.h"

/// \addtogroup world
/// @{
namespace joints {

/// Sequential Impulses, projected block Gauss-Seidel on the impulses: each iteration solves every
/// block exactly at the present velocities, in the order of the list.
/// Source: Catto, "Fast and Simple Physics using Sequential Impulses", GDC 2006.
class SequentialImpulses : public IterativeSolver {
 public:
  bool row_by_row = false;  ///< solve each row as a block of its own (chapter 2)

  void solve(Bodies& bodies) override;

  // Pieces of solve(), to measure between iterations or to choose another order.

  /// One iteration over all prepared blocks.
  void iterate(Bodies& bodies);
  /// One iteration over the prepared blocks [from, to); with row_by_row each row is one.
  /// \throws std::invalid_argument unless there are so many
  void iterate(Bodies& bodies, int from, int to);
  /// The number of prepared blocks: the blocks of the step, or their rows with row_by_row.
  int prepared_count() const { return int(prepared_.blocks.size()); }

 private:
  bool rows_apart() const override { return row_by_row; }
  template <int N>
  void solve_rows(Body* bodies, const Row* J, const PreparedBlock& block);
  template <int N, bool linear, bool angular>
  void solve_block(Body* bodies, const Row* J, const PreparedBlock& block);
};

}  // namespace joints
/// @}
