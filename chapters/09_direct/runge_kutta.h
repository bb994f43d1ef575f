// The classical Runge-Kutta method on the direct solver: the reference for all others. Given, there
// is nothing to edit here.
#pragma once

#include "chapters/09_direct/direct_solver.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// Moves a world by the Runge-Kutta method of order 4. The constraint forces are those that make
/// every C'' zero; after a step, positions and velocities are projected onto the constraints. Rows
/// are appended about 14 times a step: slow, and exact. For rows without bounds: no limits, motors,
/// ropes and contacts. Joint forces are not reported.
class RungeKutta {
 public:
  /// \param h step [s] \throws std::invalid_argument unless it is positive and finite, or if a
  /// row is bounded; the world has not moved then
  void step(World& world, real h);

 private:
  struct State {  // of a body, or its change in time
    vec3 x{0};
    quat q{1, 0, 0, 0};
    vec3 v{0}, w{0};
  };
  void read(const Bodies& bodies);
  void write(Bodies& bodies, real c, const std::vector<State>& slope) const;
  void find_slope(World& world, std::vector<State>& slope);
  void collect(World& world, Blocks& blocks);
  void find_row_rates(World& world);
  void project(World& world);

  DirectSolver solver_;
  real h_ = 0;
  Blocks displaced_;
  std::vector<double> rates_;            // right-hand side
  std::vector<State> start_, sum_, slope_;
};

}  // namespace joints
/// @}
