// What a step looks over: all its input before it changes anything, and all bodies at its end.
#pragma once

#include "engine/step.h"

/// \addtogroup world
/// @{
namespace joints {

constexpr real shortest_step = real(1e-9);  ///< [s]
constexpr real longest_step = real(1e9);    ///< [s]

/// Looks over a world that is about to be moved: gravity, each body by check(const Body&), each
/// joint by Joint::check_input(). \param h step [s], from shortest_step to longest_step
/// \throws std::invalid_argument that names body or joint by its number, member and value
void check_input(const World& world, real h);
/// The same, and the settings of a step: Solver::check() and those of Stepping.
void check_input(const World& world, const Solver& solver, real h, const Stepping& how);

/// \throws std::overflow_error that names a body whose pose or velocities are not finite
void check_motion(const Bodies& bodies);

}  // namespace joints
/// @}
