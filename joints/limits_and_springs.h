// Limits and springs of a free coordinate, and when it need not be measured. Given: there is
// nothing to edit here.
#pragma once

#include <algorithm>
#include <numbers>

#include "chapters/03_hinge/hinge.h"
#include "engine/joint.h"
#include "engine/kept/state_stream.h"

/// \addtogroup chapter3
/// @{
namespace joints {

/// One limit of a coordinate as a part: C = sign (x - bound) >= 0.
template <class Coordinate>
struct Limit {
  Coordinate coordinate;  ///< the part whose error is x
  real bound = 0;         ///< the value of x at the limit [rad or m]
  real sign = 1;          ///< +1 for a lower limit, -1 for an upper one

  static constexpr int rows = 1;           ///< one row
  static constexpr bool one_sided = true;  ///< its impulse only increases C
  static constexpr Form form = Coordinate::form;  ///< the form of its row
  /// C, the gap to the limit [rad or m]; negative beyond it.
  real error(const Body& body1, const Body& body2) const {
    return sign * (coordinate.error(body1, body2) - bound);
  }
  /// The row of the coordinate, times the sign of the limit.
  Row jacobian(const Body& body1, const Body& body2) const {
    const Row J = coordinate.jacobian(body1, body2);
    return {sign * J.v1, sign * J.w1, sign * J.v2, sign * J.w2};
  }
};

/// The largest magnitude of a finite limit [rad or m].
constexpr real max_limit = real(1e9);
/// Validates it. \throws std::invalid_argument unless lower <= upper, infinite or in max_limit
inline void check(const Range& range) {
  const auto [lower, upper] = range;
  require(lower <= upper && lower < unbounded && upper > -unbounded,
          "lower: must not be above upper, and neither infinite on its wrong side [rad or m]");
  for (const real bound : {lower, upper})
    require(std::abs(bound) <= max_limit || std::abs(bound) == unbounded,
            bound == lower ? "lower" : "upper", bound,
            "must be within 1e9 [rad or m]; infinite for no limit");
}
/// Validates it. \throws std::invalid_argument unless |speed| <= max_speed and strength >= 0
inline void check(const Motor& motor) {
  require(std::abs(motor.speed) <= max_speed, "speed", motor.speed,
          "must be within 3e8 [rad/s or m/s]");
  require(motor.strength >= 0, "strength", motor.strength, "must not be negative [N m or N]");
}

/// A spring and damper on a coordinate: its force is -stiffness (x - rest) - damping dx/dt, at most
/// `strength`. Units for an angle; for a displacement N/m, N s/m, m and N. It has this stiffness
/// whatever the bodies' masses, and its position at rest is exact. The step is implicit in time and
/// adds a damping ratio of about omega h/2, so an oscillation dies out: use substeps against it.
struct Spring {
  real stiffness = 0;         ///< k [N m/rad]
  real damping = 0;           ///< c [N m s/rad]
  real rest = 0;              ///< the value of x at which it exerts no force [rad]
  real strength = unbounded;  ///< greatest torque in either direction [N m]
  /// True if it has a row.
  bool acts() const { return strength > 0 && (stiffness > 0 || damping > 0); }
};
/// Validates it. \throws std::invalid_argument unless all numbers are finite (the strength may be
/// infinite), the rest position is within max_limit and nothing else is negative
inline void check(const Spring& spring) {
  require(spring.stiffness >= 0 && spring.stiffness < unbounded, "stiffness", spring.stiffness,
          "must be finite and not negative [N m/rad or N/m]");
  require(spring.damping >= 0 && spring.damping < unbounded, "damping", spring.damping,
          "must be finite and not negative [N m s/rad or N s/m]");
  require(std::abs(spring.rest) <= max_limit, "rest", spring.rest, "must be within 1e9 [rad or m]");
  require(spring.strength >= 0, "strength", spring.strength, "must not be negative [N m or N]");
}

/// A natural frequency [Hz] and a damping ratio [1], as in RowSettings and Joint.
struct Tuning {
  real frequency = 0;  ///< [Hz]
  real damping = 0;    ///< [1]
};
/// The tuning of a row that has the stiffness k and the damping c: omega^2 = k K and 2 zeta omega =
/// c K (Eq. 6-18). Without stiffness, omega is a millionth of c K. \param K J M^-1 J^T of the row
/// [1/kg or 1/(kg m^2)]
inline Tuning tuning(real stiffness, real damping, real K) {
  const real omega = std::sqrt(stiffness * K), least = real(1e-6) * damping * K;
  const real w = std::max(omega, least);
  if (!(w > 0)) return {};
  return {w / 2 / std::numbers::pi_v<real>, damping * K / (2 * w)};  // Eq. 6-18
}

/// Decides when a step need not measure the coordinate: it skips atan2 while the limits of a hinge
/// are out of reach. A displacement is always measured.
///
/// The angle's rate is g.(w2 - w1), |g| = 1/cos(alpha/2), alpha the angle between the axes
/// (Eq. 3-10). Below alpha = 83 degrees |g| < 1.34, so the angle changes by less than 1.34 times
/// what the bodies turn. Half of the slack is for their turns since the measurement, half for this
/// step. From 26 degrees at a measurement both together lead to at most 26 + 2 x 28 = 82.
class Leeway {
 public:
  /// Called after each measurement: stores both orientations and the allowed rotation.
  /// \param slack distance to the nearer limit [rad]
  void measured(const HingeAngle& angle, const Body& body1, const Body& body2, real slack) {
    q1_ = body1.q;
    q2_ = body2.q;
    const vec3 a1 = to_world(body1, angle.a1_local);
    const vec3 a2 = to_world(body2, conjugate(angle.start) * angle.a1_local);
    const bool aligned = dot(a1, a2) > real(0.9);  // alpha below 26 degrees
    allowed_ = aligned ? std::min(slack / real(2.7), real(0.49)) : real(0);
    // In float the cosine of a small angle is too inexact, so every step measures.
    least_cosine_ = allowed_ > real(0.02) ? std::cos(allowed_ / 4) : real(2);
  }
  /// A displacement has no leeway.
  template <class Coordinate>
  void measured(const Coordinate&, const Body&, const Body&, real) {}
  void forget() { least_cosine_ = 2; }  ///< the next step measures in any case
  /// Saves or restores the measurement (Joint::serialize).
  void serialize(StateStream& stream) { stream(q1_, q2_, allowed_, least_cosine_); }
  /// True if the rotation of each body since the measurement is below half of the allowed one.
  bool still_near(const Body& body1, const Body& body2) const {
    return std::abs(dot(q1_, body1.q)) > least_cosine_ &&
           std::abs(dot(q2_, body2.q)) > least_cosine_;
  }
  /// True if the relative rotation in this step is below the allowed one. \param h step [s]
  bool is_slow(const Body& body1, const Body& body2, real h) const {
    const vec3 phi = h * (body2.w - body1.w);
    return least_cosine_ < 1 && dot(phi, phi) < allowed_ * allowed_;
  }

 private:
  quat q1_{1, 0, 0, 0}, q2_{1, 0, 0, 0};  // orientations at the measurement
  real allowed_ = 0;       // of both bodies since the measurement, and again in this step [rad]
  real least_cosine_ = 2;  // cos(allowed_/4); one body may rotate by allowed_/2. Above 1: measure
};

}  // namespace joints
/// @}
