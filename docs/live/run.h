// A run of the live page: a scene with the settings of the page, its steps, and a look into one.
#pragma once

#include <optional>

#include "direct/direct_solver.h"
#include "docs/live/scenes.h"

/// \addtogroup live
/// @{
namespace joints::live {

/// A joint within a step.
struct JointLook {
  double body1, body2;       ///< slots
  glm::dvec3 place;          ///< where it holds [m, world]
  double error;              ///< of its rows, root of the sum of squares [m/s, rad/s]
  glm::dvec3 impulse;        ///< on body 2 [N s]
  double next;               ///< 1 if the next block to be solved is one of its
};

/// A row of a joint that holds a position, with the bodies at poses that may be another run's.
struct RowLook {
  double joint;         ///< counted from 0
  double row;           ///< counted from 1; 0 for a one-sided row
  double body1, body2;  ///< slots
  double error;         ///< of its position, 0 where a one-sided row allows it [m, rad]
  double moves;         ///< 1: its direction is one of a displacement; 0: an axis of rotation
  glm::dvec3 direction;  ///< [1, world]
};

/// A scene, its solver, its time.
class LiveRun {
 public:
  /// Makes the scene. \param ratio factor of its heavy body's mass [1]; none: the scene's own
  explicit LiveRun(const Entry& entry, std::optional<double> ratio = {});
  /// The settings that its scene begins with.
  PageSettings settings() const;
  /// \throws std::invalid_argument for settings that step() rejects
  void set(const PageSettings& settings);
  /// One step. \throws std::overflow_error after a number has overflowed
  void step();

  double time() const { return time_; }  ///< since the beginning [s]
  const Scene& scene() const { return *live_.scene; }  ///< what runs
  bool has_motor() const { return bool(live_.drive); }  ///< speed and strength mean something
  bool has_own() const { return bool(live_.own); }  ///< a loop of the exercises can do the steps
  double energy_scale() const { return energy_scale_; }  ///< the scene's with this mass ratio [J]
  double gap() const;     ///< the largest of all joints [m]
  double energy() const;  ///< what the bodies have gained since the beginning [J]

  /// A hand holds a body by a soft joint. \param point of the body [m, world]
  void grab(int slot, const vec3& point);
  void move_hand(const vec3& point);  ///< \param point [m, world]
  void let_go();                      ///< the hand is gone

  /// The joints within the next step, after so many iterations and blocks more. The run is left as
  /// it was.
  std::vector<JointLook> look(int iterations, int blocks);
  /// What this code's rows say of other poses. The run is left as it was.
  /// \param poses of each body x and q (w, x, y, z) [m, world]
  std::vector<RowLook> rows_at(const std::vector<double>& poses);
  int blocks();  ///< the number of blocks of the next step's beginning
  /// The largest velocity error of a joint after 0, 1, 2 ... iterations of the next step [m/s,
  /// rad/s].
  std::vector<double> errors(int most);
  /// The factor by which an iteration multiplies the error in the long run [1].
  double rate(int most);

 private:
  std::vector<RowLook> rows_now();
  void within(int iterations, int blocks, const std::function<void()>& look);
  std::vector<JointLook> joints_now(int blocks) const;
  Solver& solver();
  real h_sub() const { return live_.scene->h / real(live_.scene->stepping.substeps); }
  World& world() const { return live_.scene->world; }

  LiveScene live_;
  DirectSolver direct_ = DirectSolver::velocities_only();
  bool is_direct_ = false, is_own_ = false;
  double ratio_, tilt_ = 0, speed_, strength_, beta_, time_ = 0, energy_0_ = 0,
      energy_scale_;
  std::optional<BodyId> hand_;
};

}  // namespace joints::live
/// @}
