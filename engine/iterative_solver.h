// Common code of the iterative solvers: their settings, and the bounds that follow an impulse.
#pragma once

#include "engine/solver.h"

/// \addtogroup rows
/// @{
namespace joints {

/// A row of a block.
struct RowOfBlock {
  int block = 0;  ///< index in Blocks::list
  int row = 0;    ///< from 0, within the block
};
/// The row whose impulse bounds block number k, which must follow one (RowTarget::follows).
/// \throws std::invalid_argument if that impulse has no row, or if the block has several rows
RowOfBlock followed_row(const Blocks& blocks, int k);

/// @}
/// \addtogroup world
/// @{

/// A solver that solves one block after the other, in several iterations. For every block it adds
/// dlambda of StepTarget to the accumulated impulses and clamps the last one to its bounds (-+upper
/// times the other impulse, if it follows one). It changes the impulses of the other rows by
/// Kinv[i][last] / Kinv[last][last] times the change that the clamp made, and then changes the
/// velocities. SequentialImpulses::solve_block is the reference.
class IterativeSolver : public Solver {
 public:
  int iterations = 30;  ///< iterations over all blocks per solve()
  real relaxation = 1;  ///< over-relaxation: factor of every impulse change [1]; stable below 2

  void check() const override;
};

}  // namespace joints
/// @}
