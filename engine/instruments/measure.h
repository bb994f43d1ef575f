// Measuring: gaps and axis errors from poses and marks, energy from the bodies' state, all in
// double. The engine does not include this file.
#pragma once

#include <span>
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

/// The poses of all slots of the array.
std::vector<Pose> poses(const Bodies& bodies);
/// The same of any bodies, into a vector that exists, without allocation once it is long enough.
void poses(std::span<const Body> bodies, std::vector<Pose>& out);
/// The whole array, empty slots included.
std::span<const Body> all_of(const Bodies& bodies);

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
  void add(double gap);                   ///< one more gap, measured in another way [m]
  double rms() const;                     ///< [m]
  double maximum() const { return max_; }  ///< [m]
  double axis_maximum() const { return axis_max_; }  ///< [rad]

 private:
  double sum_of_squares_ = 0, max_ = 0, axis_max_ = 0;
  long count_ = 0;
};

/// Energy of motion [J] of one body, 0 for a static one.
double kinetic_energy(const Body& body);
/// Energy of motion and of position of all bodies [J], zero at rest in the origin. With leapfrog it
/// is that of the poses only with the bodies of synchronised().
double energy(std::span<const Body> bodies, const vec3& gravity);
/// Momentum of bodies, static ones left out.
struct Momentum {
  glm::dvec3 linear{0};   ///< [kg m/s]
  glm::dvec3 angular{0};  ///< about the origin [kg m^2/s]
};
/// The momentum of all these bodies together.
Momentum momentum(std::span<const Body> bodies);
/// True while every place, orientation and velocity of every body is an ordinary number.
bool all_finite(std::span<const Body> bodies);

}  // namespace joints
/// @}
