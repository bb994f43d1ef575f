// Measuring: gaps, axis errors, energy and momentum, from poses and marks alone and in double, so
// that any engine can be measured by the same code. The engine does not include this file.
#pragma once

#include <vector>

#include "engine/body.h"

/// \defgroup measuring Measuring and recording
/// \brief What is read off a simulation, and the files it goes to.
/// @{
namespace joints {

/// Place and orientation of one body, all that a measure needs to know of it.
struct Pose {
  glm::dvec3 x{0};           ///< centre of mass [m]
  glm::dquat q{1, 0, 0, 0};  ///< body space to world
};

/// What a body weighs; all zero for a static one, which then counts nowhere.
struct MassProperties {
  double mass = 0;       ///< [kg]
  glm::dvec3 inertia{0};  ///< principal moments [kg m^2]
};

/// The poses of all slots of the array.
std::vector<Pose> poses(const Bodies& bodies);
/// The same into a vector that exists, without allocation once it is long enough.
void poses(const Bodies& bodies, std::vector<Pose>& out);
/// The masses of all slots of the array.
std::vector<MassProperties> masses(const Bodies& bodies);

/// A place that ought to stay together: a point, and where wanted an axis, of each of two bodies.
struct Mark {
  int body1 = 0, body2 = 0;                ///< slots
  glm::dvec3 anchor1_local{0}, anchor2_local{0};  ///< [m, body space]
  glm::dvec3 axis1_local{0}, axis2_local{0};      ///< unit, body space; zero where none
};

/// Distance between the two points of a mark [m].
double gap(const Mark& mark, const std::vector<Pose>& poses);
/// Angle between the two axes of a mark [rad], 0 where it has none.
double axis_error(const Mark& mark, const std::vector<Pose>& poses);

/// RMS and maximum over all marks and all the moments it was shown.
class GapMeter {
 public:
  /// Looks at every mark once.
  void look(const std::vector<Mark>& marks, const std::vector<Pose>& poses);
  double rms() const;                     ///< [m]
  double maximum() const { return max_; }  ///< [m]
  double axis_maximum() const { return axis_max_; }  ///< [rad]

 private:
  double sum_of_squares_ = 0, max_ = 0, axis_max_ = 0;
  long count_ = 0;
};

/// Three poses of every body, one step apart: velocities are their central differences.
struct Moment {
  const std::vector<Pose>& before;  ///< one step earlier
  const std::vector<Pose>& now;     ///< the moment itself
  const std::vector<Pose>& after;   ///< one step later
  double h;                         ///< the step between two of them [s]
};

/// Energy of position [J], zero at the origin.
double potential_energy(const std::vector<Pose>& poses, const std::vector<MassProperties>& masses,
                        const glm::dvec3& gravity);
/// Energy of motion [J].
double kinetic_energy(const Moment& moment, const std::vector<MassProperties>& masses);
/// Linear momentum [kg m/s].
glm::dvec3 momentum(const Moment& moment, const std::vector<MassProperties>& masses);
/// Angular momentum about the origin [kg m^2/s].
glm::dvec3 angular_momentum(const Moment& moment, const std::vector<MassProperties>& masses);

/// Energy of motion [J] of one body from its own velocities, 0 for a static one.
double kinetic_energy(const Body& body);

}  // namespace joints
/// @}
