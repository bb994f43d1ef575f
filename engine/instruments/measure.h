// Measuring: gaps and axis errors from poses and marks, energy from the bodies' state, all in
// double. The engine does not include this file.
#pragma once

#include <span>
#include <vector>

#include "engine/body.h"

/// \defgroup measuring Measuring and recording
/// \brief Measurements of a simulation, and the files in which they are stored.
/// @{
namespace joints {

/// Position and orientation of one body; measurements need nothing else of it.
struct Pose {
  glm::dvec3 x{0};           ///< centre of mass [m]
  glm::dquat q{1, 0, 0, 0};  ///< body space to world
};

/// The poses of all slots of the array.
std::vector<Pose> poses(const Bodies& bodies);
/// The poses of any bodies, stored in `out`; no allocation once it is long enough.
void poses(std::span<const Body> bodies, std::vector<Pose>& out);
/// The whole array, empty slots included.
std::span<const Body> all_of(const Bodies& bodies);

/// A point, and optionally an axis, of each of two bodies that a joint should keep together.
struct Mark {
  int body1 = 0, body2 = 0;                ///< slots
  glm::dvec3 anchor1_local{0}, anchor2_local{0};  ///< [m, body space]
  glm::dvec3 axis1_local{0}, axis2_local{0};      ///< unit, body space; zero: no axis
};

/// Distance between the two points of a mark [m].
double gap(const Mark& mark, const std::vector<Pose>& poses);
/// Angle between the two axes of a mark [rad], 0 if it has none.
double axis_error(const Mark& mark, const std::vector<Pose>& poses);

/// RMS and maximum of the gaps over all marks and all times at which they were measured.
class GapMeter {
 public:
  /// Measures every mark once.
  void look(const std::vector<Mark>& marks, const std::vector<Pose>& poses);
  void add(double gap);                   ///< adds a gap that was measured elsewhere [m]
  double rms() const;                     ///< [m]
  double maximum() const { return max_; }  ///< [m]
  double axis_maximum() const { return axis_max_; }  ///< [rad]

 private:
  double sum_of_squares_ = 0, max_ = 0, axis_max_ = 0;
  long count_ = 0;
};

/// Kinetic energy of one body [J], 0 for a static one.
double kinetic_energy(const Body& body);
/// Kinetic and potential energy of all bodies [J], zero at rest at the origin. With leapfrog the
/// velocities belong to the time of the poses only for the bodies of velocities_at_pose_time().
double energy(std::span<const Body> bodies, const vec3& gravity);
/// Momentum of bodies without the static ones.
struct Momentum {
  glm::dvec3 linear{0};   ///< [kg m/s]
  glm::dvec3 angular{0};  ///< about the origin [kg m^2/s]
};
/// The momentum of all these bodies together.
Momentum momentum(std::span<const Body> bodies);
/// True if every position, orientation and velocity of every body is finite.
bool all_finite(std::span<const Body> bodies);

}  // namespace joints
/// @}
