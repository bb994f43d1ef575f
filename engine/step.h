// The step: advances a world by h. Algorithm 1 of the thesis, on one screen in step.cpp.
#pragma once

#include "engine/solver.h"
#include "engine/world.h"

/// \addtogroup world
/// @{
namespace joints {

/// Settings of a step. An aggregate: name only what you need, as in
/// `step(world, solver, h, {.warm_start = true})`.
struct Stepping {
  bool warm_start = false;  ///< begin with the impulses of the last step
  int substeps = 1;         ///< solve the step as this many substeps of equal length (chapter 6)
  int projections = 0;      ///< iterations of position projection after each substep (chapter 6)
  /// Second order in time (Eq. 9-9): forces act for the mean of the last step and this one, so for
  /// h/2 in the first; half of the gyroscopic torque acts before the bodies move, half after. A
  /// motor between long bodies has its speed before that first half, and is off by what it does.
  bool leapfrog = false;
  /// Constraint softness: natural frequency [Hz] of the spring that takes the place of beta in each
  /// block that holds a position and is not soft already (Catto 2011); 0 leaves all blocks alone.
  real frequency = 0;
  real damping = 1;         ///< damping ratio of these springs [1]; 1 is critical
};

/// Advances the world by one step of semi-implicit Euler: forces change the velocities, the solver
/// finds the impulses of all joints, and the new velocities move the bodies. Allocates only when
/// there are more rows than ever before, or the solver has to regroup its blocks.
/// \param h step [s]
/// \throws std::invalid_argument for what check_input() of engine/input.h refuses: h, settings,
/// bodies and joints. Nothing in the world has changed then, and it is said again at every try.
/// \throws std::overflow_error at the end of a substep in which a number of a body has overflowed.
/// All bodies that no joint connects with it have moved as ever; remove it, or put it right.
///
/// A block whose RowTarget::follows names no row is a mistake in the class of its joint: it shows
/// only when the blocks are prepared, after the forces.
void step(World& world, Solver& solver, real h, const Stepping& how = {});

/// The bodies with the velocities that belong to their poses. After a step with leapfrog those in
/// the world belong to the middle of that step, and energies and speeds made of them are half a
/// step late: here forces and joints act for the other half, and nothing is fed back. Otherwise the
/// bodies as they are. The world is left as it was, but for World::blocks, which are empty.
/// Source: Andersen, "Rattle", 1983. \param solver one of its own, so that it begins with nothing
Bodies synchronised(World& world, Solver& solver, const Stepping& how);

// The two ends of a step, to measure between the iterations. They do neither substeps nor late
// limits: call solve() or iterate() between them.

/// Looks over all input, integrates the forces, collects the joints' blocks, prepares them and
/// starts warm or cold. \throws std::invalid_argument as step()
void begin_step(World& world, Solver& solver, real h, const Stepping& how = {});
/// Moves the bodies and projects the positions. \throws std::overflow_error as step()
void end_step(World& world, Solver& solver, real h, const Stepping& how = {});

}  // namespace joints
/// @}
