// A step with options: warm starting, substeps, position projection, second order in time, soft
// rows, rows one by one. Each of them is explained where it is built, in a file of this folder.
#pragma once

#include "engine/step.h"

/// \addtogroup world
/// @{
namespace joints {

/// Settings of a step. An aggregate: set only the members that you need, as in
/// `step(world, solver, h, {.warm_start = true})`.
struct StepOptions {
  bool warm_start = false;  ///< start from the impulses of the last step
  int substeps = 1;         ///< number of substeps of equal length in a step (chapter 6)
  int projections = 0;      ///< calls of project_positions() after each substep (chapter 6)
  bool leapfrog = false;    ///< second order in time (leapfrog.h, Eq. 9-9)
  real frequency = 0;       ///< above 0: hard rows become springs of it [Hz] (soft.h)
  real damping = 1;         ///< damping ratio of these springs [1]
  bool row_by_row = false;  ///< solve each row as a block of its own (rows.h, chapter 2)
};
/// Its name before version 0.10.
using Stepping [[deprecated("write StepOptions")]] = StepOptions;
/// Validates them, for a world and a step. \param h length of a substep [s]
/// \throws std::invalid_argument as step()
void check_input(const World& world, const Solver& solver, real h, const StepOptions& how);

/// Advances a world by one step of `how.substeps` substeps.
/// \param h step [s]
/// \throws std::invalid_argument if check_input() rejects h, the settings, a body or a joint.
/// Nothing in the world has changed then, and every further call throws again.
/// \throws std::overflow_error at the end of a substep in which a number of a body has overflowed.
/// Bodies that no joint connects with it have moved as usual. Remove that body or correct it.
///
/// A block whose RowSettings::follows refers to no row is a mistake in the class of its joint. It
/// is detected only when the blocks are prepared, after the forces have been applied.
void step(World& world, Solver& solver, real h, const StepOptions& how = {});

// The first and the last part of a step, for measurements between the iterations: call solve() or
// iterate() between them. They perform no substeps and add no late limits.

/// Validates all input, integrates the forces, collects the joints' blocks, prepares them and
/// performs the warm or cold start. \throws std::invalid_argument as step()
void begin_step(World& world, Solver& solver, real h, const StepOptions& how = {});
/// Moves the bodies and projects the positions. \throws std::overflow_error as step()
void end_step(World& world, Solver& solver, real h, const StepOptions& how = {});

}  // namespace joints
/// @}
