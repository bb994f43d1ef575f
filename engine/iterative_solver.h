// What iterative solvers share: their settings, and what a block's target means in a step.
#pragma once

#include "engine/solver.h"

/// \addtogroup rows
/// @{
namespace joints {

/// A block's target in a step of one length: what the inner loop reads of it. For every block it
/// adds dlambda = -mass_scale K^-1 (J V + bias) - impulse_scale lambda to the accumulated impulses.
struct StepTarget {
  real rate;           ///< Feedback::rate
  real mass_scale;     ///< relaxation / (1 + softness) [1]
  real impulse_scale;  ///< relaxation - mass_scale: 0 for hard rows [1]
  real lower, upper;   ///< bounds of the last row's accumulated impulse [N s or N m s]; if another
                       ///< impulse bounds it, `upper` is RowTarget::upper, the factor
};
/// \param h step [s] \param acting Blocks::acts() [s] \param relaxation over-relaxation [1]
StepTarget step_target(const RowTarget& target, real h, real acting, real relaxation);

/// The row whose impulse bounds block number k, RowTarget::follows: its index in Blocks::J; -1 if
/// none does. \throws std::invalid_argument if that impulse has no row, or the block several rows
int followed_row(const Blocks& blocks, int k);

/// @}
/// \addtogroup world
/// @{

/// A solver that solves one block after the other, in several iterations. For every block it adds
/// StepTarget's dlambda to the accumulated impulses, clamps the last one to its bounds (-+upper
/// times the other impulse, if it follows one), changes the other rows by
/// Kinv[i][last] / Kinv[last][last] for each unit that was cut, and changes the velocities:
/// SequentialImpulses::solve_block is the reference.
class IterativeSolver : public Solver {
 public:
  int iterations = 30;  ///< over all blocks, per solve()
  real relaxation = 1;  ///< over-relaxation: a factor of every impulse change [1]; stable below 2

  void check() const override;
};

}  // namespace joints
/// @}
