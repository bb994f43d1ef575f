// The step: how a world moves on in time. Algorithm 1 of the thesis, on one screen in step.cpp.
#pragma once

#include "engine/solver.h"
#include "engine/world.h"

/// \addtogroup world
/// @{
namespace joints {

/// How a step advances. An aggregate: name only what you need, as in
/// `step(world, solver, h, {.warm_start = true})`.
struct Stepping {
  bool warm_start = false;  ///< begin with the impulses of the last step
  int substeps = 1;         ///< the step as so many shorter ones (chapter 6)
  int projections = 0;      ///< iterations of position projection after each of them (chapter 6)
  bool half_kick = false;   ///< take half a step of gravity off before the first step (Eq. 7-9)
  /// Constraint softness: every row that holds a position is a spring of this natural frequency
  /// [Hz] instead of feeding beta back (Catto 2011); 0: each block keeps its own row target.
  real frequency = 0;
  real damping = 1;         ///< ratio of these springs' damping to the critical one [1]
};

/// Moves the world on by one step of semi-implicit Euler: forces change the velocities, the solver
/// finds the impulses of all joints, and the new velocities move the bodies. Allocates only when
/// the world has grown since the last step.
/// \param h step [s] \throws std::invalid_argument unless h is positive and finite and the settings
/// of solver and step make sense; the world has not moved then
void step(World& world, Solver& solver, real h, const Stepping& how = {});

// The two ends of a step, for those who look between the iterations (chapter 2, tests).

/// Forces, the joints' blocks, their preparation and the warm start.
void begin_step(World& world, Solver& solver, real h, const Stepping& how = {});
/// The poses from the velocities, and position projection.
void end_step(World& world, real h, const Stepping& how = {});

}  // namespace joints
/// @}
