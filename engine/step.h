// The step, which advances a world by h: Algorithm 1 of the thesis. step.cpp has all of it.
#pragma once

#include "engine/solver.h"
#include "engine/world.h"

/// \addtogroup world
/// @{
namespace joints {

/// Settings of a step. An aggregate: set only the members that you need, as in
/// `step(world, solver, h, {.warm_start = true})`.
struct Stepping {
  bool warm_start = false;  ///< start from the impulses of the last step
  int substeps = 1;         ///< number of substeps of equal length in a step (chapter 6)
  int projections = 0;      ///< calls of project_positions() after each substep (chapter 6)
  /// Second order in time (Eq. 9-9). Forces act for the mean of the lengths of the last step and
  /// this one, so for h/2 in the first step. Half of the gyroscopic torque acts before the bodies
  /// move, and half after. The speed of a motor is set before the first of these halves, so between
  /// elongated bodies it deviates by the effect of that half.
  bool leapfrog = false;
  /// Constraint softness: natural frequency [Hz] of the spring that replaces beta in each block
  /// that holds a position and is not already soft (Catto 2011). With 0 no block is changed.
  real frequency = 0;
  real damping = 1;         ///< damping ratio of these springs [1]; 1 is critical
};

/// Advances the world by one step of semi-implicit Euler: forces change the velocities, the solver
/// computes the impulses of all joints, and the new velocities move the bodies. Memory is allocated
/// only when there are more rows than in any step before, or when the solver has to regroup its
/// blocks.
/// \param h step [s]
/// \throws std::invalid_argument if check_input() of engine/input.h rejects h, the settings, a body
/// or a joint. Nothing in the world has changed then, and every further call throws again.
/// \throws std::overflow_error at the end of a substep in which a number of a body has overflowed.
/// Bodies that no joint connects with it have moved as usual. Remove that body or correct it.
///
/// A block whose RowTarget::follows refers to no row is a mistake in the class of its joint. It is
/// detected only when the blocks are prepared, after the forces have been applied.
void step(World& world, Solver& solver, real h, const Stepping& how = {});

/// The bodies with velocities at the same time as their poses. After a step with leapfrog the
/// velocities in the world belong to the middle of that step, so energies and speeds computed from
/// them lag by half a step. This function lets forces and joints act for the other half, without
/// feedback. Without leapfrog it returns the bodies unchanged. The world is not changed, except
/// that World::blocks are empty afterwards. Source: Andersen, "Rattle", 1983.
/// \param solver a separate solver, which is not used for the steps
Bodies synchronised(World& world, Solver& solver, const Stepping& how);

// The first and the last part of a step, for measurements between the iterations: call solve() or
// iterate() between them. They perform no substeps and add no late limits.

/// Validates all input, integrates the forces, collects the joints' blocks, prepares them and
/// performs the warm or cold start. \throws std::invalid_argument as step()
void begin_step(World& world, Solver& solver, real h, const Stepping& how = {});
/// Moves the bodies and projects the positions. \throws std::overflow_error as step()
void end_step(World& world, Solver& solver, real h, const Stepping& how = {});

}  // namespace joints
/// @}
