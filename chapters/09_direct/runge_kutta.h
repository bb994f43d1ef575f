// The classical Runge-Kutta method on the direct solver: the reference for all others. Given, there
// is nothing to edit here.
#pragma once

#include "chapters/09_direct/direct_solver.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// Moves a world by the Runge-Kutta method of order 4. The constraint forces are chosen so that
/// every C'' is zero; after a step, positions and velocities are projected onto the constraints. A
/// joint with a frequency acts as the spring and damper that its soft rows approach for short
/// steps. A step appends the rows about 14 times, so it is slow but accurate. It accepts only rows
/// without bounds: no limits, motors, ropes or contacts. Joints report the mean force of the step.
/// The velocities belong to the time of the poses: set World::last_h to 0 before a step with
/// leapfrog.
class RungeKutta {
 public:
  /// Called in every stage with the bodies at that stage. It must set their `force` and `torque` as
  /// functions of their state and the time, and change nothing else. If it is empty, forces and
  /// torques are constant. \param time since the beginning of the step [s]
  std::function<void(Bodies& bodies, real time)> forces;
  /// Worlds whose factorisation takes more multiplications per row are rejected. A step factors six
  /// or seven times, and a hub of n bodies takes 1.5 n^2 multiplications per row.
  double most_work = 1e5;

  /// Makes one step. \param h step [s] \throws std::invalid_argument if it is not positive and
  /// finite, if a row has bounds, or if the factor takes too much work; the world is then unchanged
  /// \throws std::runtime_error if it finds no poses that satisfy the joints, or if forces change
  /// too much within the step; the bodies are then restored
  void step(World& world, real h);

 private:
  struct State {  // of a body, or its change in time
    vec3 x{0};
    quat q{1, 0, 0, 0};
    vec3 v{0}, w{0};
  };
  static void read(const Bodies& bodies, std::vector<State>& states);
  [[noreturn]] void give_up(Bodies& bodies, const std::string& why) const;
  void check_slopes(World& world);
  void write(Bodies& bodies, real c, const std::vector<State>& slope) const;
  void begin(World& world, real h);
  void find_slope(World& world, real time, std::vector<State>& slope);
  void collect(const World& world, Blocks& rigid, Blocks* springs) const;
  void factor(World& world);
  void find_row_rates(World& world);
  void stretch_springs(const Bodies& bodies) const;
  void reach(World& world);
  void project(World& world);

  DirectSolver solver_;
  real h_ = 0;
  Blocks displaced_, springs_;
  std::vector<double> wanted_, rates_;   // required J V of every row; its remaining error
  std::vector<State> start_, sum_, slope_, second_;
};

}  // namespace joints
/// @}
