// The step, which advances a world by h: Algorithm 1 of the thesis. Other ways to step are in
// engine/steps.
#pragma once

#include "engine/solver.h"
#include "engine/world.h"

/// \addtogroup world
/// @{
namespace joints {

/// The parts of a step that another way to step may replace. Those of the base class are
/// semi-implicit Euler.
class StepMethod {
 public:
  virtual ~StepMethod() = default;
  /// Forces change the velocities. \param h step [s]
  /// \return the time for which the impulses of this step act, Blocks::impulse_duration [s]
  virtual real integrate_forces(World& world, real h) const {
    joints::integrate_forces(world.bodies, world.gravity, h);
    return h;
  }
  /// May change the blocks from this one on, which the joints have just appended: makes their rows
  /// soft, for example.
  virtual void change_blocks(Blocks&, [[maybe_unused]] int first_block) const {}
  /// The solver moves the bodies by their velocities. \param h step [s]
  virtual void move(World& world, Solver& solver, real h) const;
};

/// Advances the world by one step: forces change the velocities, the solver computes the impulses
/// of all joints, and the new velocities move the bodies. The input is not validated: step() of
/// engine/steps/step.h does that before it calls this one.
/// \param h step [s] \param warm_start start from the impulses of the last step
void step(World& world, Solver& solver, real h, bool warm_start, const StepMethod& method);

// Its three parts.

/// Integrates the forces, collects the joints' blocks, prepares them, and performs the warm or cold
/// start. \throws std::invalid_argument if RowSettings::follows of a block refers to no row
void begin_step(World& world, Solver& solver, real h, bool warm_start, const StepMethod& method);
/// Solves, and again as long as the new velocities would pass limits within this step, or have
/// changed the mean rate of a fast rotation (at most three times).
void solve_step(World& world, Solver& solver, real h, const StepMethod& method);
/// Moves the bodies.
void end_step(World& world, Solver& solver, real h, const StepMethod& method);

}  // namespace joints
/// @}
