// Common code of the iterative solvers: their settings, and the target of a block in a step.
#pragma once

#include "engine/solver.h"

/// \addtogroup rows
/// @{
namespace joints {

/// A block's target in a step of a given length, as the inner loop uses it. For every block the
/// loop adds dlambda = -mass_scale K^-1 (J V + bias) - impulse_scale lambda to the accumulated
/// impulses.
struct StepTarget {
  real rate;           ///< Feedback::rate
  real mass_scale;     ///< relaxation / (1 + softness) [1]
  real impulse_scale;  ///< relaxation - mass_scale: 0 for hard rows [1]
  real lower, upper;   ///< bounds of the last row's accumulated impulse [N s or N m s]; if the
                       ///< bound follows another impulse, `upper` is the factor RowTarget::upper
};
/// Computes the target of a block for a step.
/// \param h step [s] \param acting Blocks::acts() [s] \param relaxation over-relaxation [1]
StepTarget step_target(const RowTarget& target, real h, real acting, real relaxation);

/// The row whose impulse bounds block number k (RowTarget::follows), as an index into Blocks::J, or
/// -1 if there is none.
/// \throws std::invalid_argument if that impulse has no row, or if the block has several rows
int followed_row(const Blocks& blocks, int k);

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
