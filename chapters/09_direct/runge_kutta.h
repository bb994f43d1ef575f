// The classical Runge-Kutta method on the direct solver: the reference for all others. Given, there
// is nothing to edit here.
#pragma once

#include "chapters/09_direct/direct_solver.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// Moves a world by the Runge-Kutta method of order 4. The constraint forces are those that make
/// every C'' zero; after a step, positions and velocities are projected onto the constraints. A
/// joint with a frequency is the spring and damper that its soft rows are in the limit of short
/// steps. Rows are appended about 14 times a step: slow, and exact. For rows without bounds: no
/// limits, motors, ropes and contacts. Joints report the mean force of the step. Velocities belong
/// to the time of the poses: before a step with leapfrog set World::last_h to 0.
class RungeKutta {
 public:
  /// Called in every stage, with the bodies at that stage: sets their `force` and `torque` to those
  /// of their state and of the time, and changes nothing else. They stay what they are if it is
  /// empty. \param time since the beginning of the step [s]
  std::function<void(Bodies& bodies, real time)> forces;
  /// Worlds whose factorisation takes more multiplications a row are refused: it is done six or
  /// seven times a step, and a hub of n bodies takes 1.5 n^2 a row.
  double most_work = 1e5;

  /// \param h step [s] \throws std::invalid_argument unless it is positive and finite, or if a
  /// row is bounded, or for too much work; the world has not moved then
  /// \throws std::runtime_error if it finds no poses that satisfy the joints, or if forces
  /// change too much within the step; the bodies are then as they were
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
  std::vector<double> wanted_, rates_;   // J V of every row that is to be reached; what it lacks
  std::vector<State> start_, sum_, slope_, second_;
};

}  // namespace joints
/// @}
