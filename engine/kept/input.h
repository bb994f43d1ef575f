// Validation in a step: all input before anything changes, and all bodies at the end.
#pragma once

#include "engine/solver.h"
#include "engine/world.h"

/// \addtogroup world
/// @{
namespace joints {

constexpr real shortest_step = real(1e-9);  ///< least h that a step accepts [s]
constexpr real longest_step = real(1e9);    ///< greatest h that a step accepts [s]

/// Validates a world before a step: gravity, each body by check(const Body&), each joint by
/// Joint::check_input(). \param h step [s], from shortest_step to longest_step
/// \throws std::invalid_argument with the number of the body or joint, the member and the value
void check_input(const World& world, real h);
/// The same, and also validates the solver's settings, Solver::check().
void check_input(const World& world, const Solver& solver, real h);

/// Validates the motion. \throws std::overflow_error with the number of a body whose pose or
/// velocities are not finite
void check_motion(const Bodies& bodies);

}  // namespace joints
/// @}
