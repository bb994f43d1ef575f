// A half-explicit Runge-Kutta method on the direct solver: the reference for all others. Given,
// there is nothing to edit here.
#pragma once

#include <array>

#include "direct/direct_solver.h"

/// \addtogroup chapter9
/// @{
namespace joints {

/// Moves a world by a Runge-Kutta method of order 4. In each of its five stages the constraint
/// forces are chosen so that J V = 0 at the poses of the next stage; after a step, the poses are
/// projected onto the constraints. A joint with a frequency acts as the spring and damper that its
/// soft rows approach for short steps. A step appends the rows six times and factors five times. It
/// accepts only rows without bounds: no limits, motors, springs of a coordinate, ropes or contacts.
/// Joints report the mean force of the step. The velocities belong to the time of the poses: set
/// World::last_h to 0 before a step with leapfrog. Source: Brasey and Hairer, "Half-explicit
/// Runge-Kutta methods for differential-algebraic systems of index 2", SIAM Journal on Numerical
/// Analysis 30, 1993.
class RungeKutta {
 public:
  /// Called in every stage with the bodies at that stage. It must set their `force` and `torque` as
  /// functions of their state and the time, and change nothing else. If it is empty, forces and
  /// torques are constant. \param time since the beginning of the step [s]
  std::function<void(Bodies& bodies, real time)> forces;
  /// Worlds whose factorisation takes more multiplications per row are rejected. A step factors
  /// five times, and a hub of n bodies takes 1.5 n^2 multiplications per row.
  double most_work = 1e5;

  /// Makes one step. \param h step [s] \throws std::invalid_argument if it is not positive and
  /// finite, if a row has bounds, or if the factor takes too much work; the world is then unchanged
  /// \throws std::runtime_error if it finds no poses that satisfy the joints, or if forces change
  /// too much within the step; the bodies are then restored
  void step(World& world, real h);

 private:
  struct Slope {  // of a body: the derivatives of its position, orientation and velocities
    vec3 x;
    quat q;
    vec3 v, w;
  };
  static constexpr int stages = 5;
  [[noreturn]] void give_up(Bodies& bodies, const std::string& why) const;
  void check_slopes(World& world);
  void begin(World& world, real h);
  void find_free_slope(World& world, real time, std::vector<Slope>& slope);
  void write(Bodies& bodies, int stage) const;
  void collect(const World& world, Blocks& rigid, Blocks* springs) const;
  void factor(World& world);
  void stretch_springs(const Bodies& bodies) const;
  void project(World& world);

  DirectSolver solver_ = DirectSolver::velocities_only();
  real h_ = 0;
  Blocks next_, springs_, next_springs_;  // of the next stage; of joints with a frequency
  Blocks poses_;                          // errors alone
  std::vector<real> wanted_;              // required J V of every row: 0, but while poses change
  std::vector<Body> given_, start_;       // as given; with velocities that the joints permit
  std::vector<Body> free_;                // of the next stage, without the joints' forces
  std::array<std::vector<Slope>, stages> slopes_;
};

}  // namespace joints
/// @}
