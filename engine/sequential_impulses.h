// Sequential Impulses (Catto 2006; Algorithm 1 of the thesis): the engine's own solver.
#pragma once

#include "engine/iterative_solver.h"

/// \addtogroup world
/// @{
namespace joints {

/// Sequential Impulses, projected Gauss-Seidel on the impulses: iterations over all blocks, each
/// solved exactly while the others wait.
/// Source: Catto, "Fast and Simple Physics using Sequential Impulses", GDC 2006.
class SequentialImpulses : public IterativeSolver {
 public:
  bool row_by_row = false;  ///< solve every row as a block of its own (chapter 2)

  void solve(Bodies& bodies) override;

  // The pieces of a solve, for those who measure between the iterations or choose another order.

  /// One iteration over all prepared blocks.
  void iterate(Bodies& bodies);
  /// Only those with numbers from `from` up to `to`; with row_by_row each row has a number.
  /// \throws std::invalid_argument unless there are so many
  void iterate(Bodies& bodies, int from, int to);
  /// How many there are: the blocks of the step, or their rows with row_by_row.
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
