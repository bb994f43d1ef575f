// The hinge of the engine. Given: there is nothing to edit here.
#pragma once

#include "chapters/02_ball/ball_joint.h"
#include "chapters/03_hinge/driven_joint.h"
#include "engine/kernels.h"

/// \addtogroup chapter3
/// @{
namespace joints {

/// Validates it. \throws std::invalid_argument unless the three vectors have length 1
inline void check(const Axis& axis) {
  const vec3 &a1 = axis.a1_local, &b = axis.b_local, &c = axis.c_local;
  if (std::abs(dot(a1, a1) + dot(b, b) + dot(c, c) - 3) < real(1e-6)) return;  // usual case
  require_unit("a1_local", a1);
  require_unit("b_local", b);
  require_unit("c_local", c);
}
/// Validates it. \throws std::invalid_argument unless the axis has length 1, `start` is a unit
/// quaternion, and the expected angle is finite
inline void check(const HingeAngle& angle) {
  const vec3& a1 = angle.a1_local;
  require(finite(angle.expected), "expected", angle.expected, "must be finite [rad]");
  if (std::abs(dot(a1, a1) + dot(angle.start, angle.start) - 2) < real(1e-6)) return;
  require_unit("a1_local", a1);
  require_unit("start", angle.start);
}

/// Skips atan2 while the limits of a hinge are out of reach. The rate of the angle is g.(w2 - w1)
/// with |g| = 1/cos(alpha/2), where alpha is the angle between the axes (Eq. 3-10). While alpha is
/// below 83 degrees, |g| is below 1.34, so the angle changes by less than 1.34 times the sum of the
/// rotations of both bodies. Half of the slack is reserved for the rotations since the measurement,
/// a quarter for each body, and the other half for this step. The two allowances together keep
/// alpha below 26 + 2 x 28 = 82 degrees.
template <>
struct Leeway<HingeAngle> {
  /// Stores both orientations and the allowed rotation.
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
  void forget() { least_cosine_ = 2; }  ///< the next step measures in any case
  /// Saves or restores the measurement (Joint::exchange).
  void exchange(StateStream& stream) { stream(q1_, q2_, allowed_, least_cosine_); }
  /// True if the rotation of each body since the measurement is below half of the allowed one.
  bool still_near(const Body& body1, const Body& body2) const {
    return std::abs(half_cosine(q1_, body1.q)) > least_cosine_ &&
           std::abs(half_cosine(q2_, body2.q)) > least_cosine_;
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

/// A hinge: it holds a point and an axis, which removes five degrees of freedom. The angle about
/// the axis is free and may have limits [rad] and a motor [rad/s, N m]. Errors: Eq. 2-1 and
/// Eq. 3-2. Rows: Eq. 2-4 and Eq. 3-4, and Eq. 3-10 for limit and motor. K of the block: Eq. 3-8.
class HingeJoint : public DrivenJoint<Point, Axis, HingeAngle> {
 public:
  /// A hinge through a point of the world, about a direction of the world. The angle is zero at
  /// the bodies' present poses. \param anchor [m, world] \param axis world, of any length
  /// \throws std::invalid_argument unless anchor and axis are finite and the axis is not zero
  HingeJoint(const Bodies& bodies, BodyId id1, BodyId id2, const vec3& anchor, const vec3& axis)
      : DrivenJoint(id1, id2, point_at(bodies[id1], bodies[id2], anchor),
                    axis_along(bodies[id1], bodies[id2], axis),
                    angle_about(bodies[id1], bodies[id2], axis)) {
    check(first);
  }
};

}  // namespace joints
/// @}
