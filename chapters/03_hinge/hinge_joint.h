// The hinge of the engine: given, there is nothing to edit here.
#pragma once

#include "chapters/02_ball/ball_joint.h"
#include "chapters/03_hinge/driven_joint.h"

/// \addtogroup chapter3
/// @{
namespace joints {

/// \throws std::invalid_argument unless the three vectors are of length 1
inline void check(const Axis& axis) {
  const vec3 &a1 = axis.a1_local, &b = axis.b_local, &c = axis.c_local;
  if (std::abs(dot(a1, a1) + dot(b, b) + dot(c, c) - 3) < real(1e-6)) return;  // a quick look
  require_unit("a1_local", a1);
  require_unit("b_local", b);
  require_unit("c_local", c);
}
/// \throws std::invalid_argument unless the axis is of length 1, `start` a rotation, and the
/// expected angle finite
inline void check(const HingeAngle& angle) {
  const vec3& a1 = angle.a1_local;
  require(finite(angle.expected), "expected", angle.expected, "must be finite [rad]");
  if (std::abs(dot(a1, a1) + dot(angle.start, angle.start) - 2) < real(1e-6)) return;
  require_unit("a1_local", a1);
  require_unit("start", angle.start);
}

/// An angle counts its turns.
inline void count_from(HingeAngle& angle, real expected) { angle.expected = expected; }

/// Skips atan2 while the limits of a hinge are out of reach. The angle's rate is g.(w2 - w1) with
/// |g| = 1/cos(s/2), where s is the angle between the two axes (Eq. 3-10): while s stays below 83
/// degrees, |g| is below 1.34, and the angle changes by less than 1.34 times the relative rotation
/// of the bodies. Half of the slack is for the rotation since the measurement, half for this step;
/// the two allowances together keep s below 26 + 2 x 28 = 82 degrees.
template <>
struct Leeway<HingeAngle> {
  /// Stores the relative orientation and the allowed rotation.
  void measured(const HingeAngle& angle, const Body& body1, const Body& body2, real slack) {
    then_ = {angle.a1_local, angle.start};
    relative_ = conjugate(body1.q) * body2.q;
    const vec3 a2_local = relative_ * (conjugate(angle.start) * angle.a1_local);
    const bool aligned = dot(angle.a1_local, a2_local) > real(0.9);  // s below 26 degrees
    allowed_ = aligned ? std::min(slack / real(2.7), real(0.49)) : real(0);
    // In float the cosine of a small angle is too inexact: every step measures then.
    least_cosine_ = allowed_ > real(0.01) ? std::cos(allowed_ / 2) : real(2);
  }
  void forget() { least_cosine_ = 2; }  ///< the next step measures in any case
  /// True if the relative rotation since the measurement is below the allowed one.
  bool still_near(const HingeAngle& angle, const Body& body1, const Body& body2) const {
    const quat was = body1.q * relative_;  // body 2's orientation if nothing had rotated since
    const real cosine = dot(was, body2.q);  // of half the rotation from `was` to body2.q
    return std::abs(cosine) > least_cosine_ && angle.a1_local == then_.axis &&
           angle.start == then_.start;
  }
  /// True if this step's relative rotation is below the allowed one. \param h step [s]
  bool is_slow(const Body& body1, const Body& body2, real h) const {
    const vec3 phi = h * (body2.w - body1.w);
    return least_cosine_ < 1 && dot(phi, phi) < allowed_ * allowed_;
  }

 private:
  // The angle's geometry at the measurement: the user may change it between steps.
  struct Geometry {
    vec3 axis{0};
    quat start{1, 0, 0, 0};
  };
  Geometry then_;
  quat relative_{1, 0, 0, 0};  // q1^-1 q2 at the measurement
  real allowed_ = 0;           // relative rotation since then, and again in one step [rad]
  real least_cosine_ = 2;      // cos(allowed_/2); above 1: measure
};

/// A hinge: a point and an axis are held (five degrees of freedom), the angle about the axis stays
/// free and may have limits [rad] and a motor [rad/s, N m].
class HingeJoint : public DrivenJoint<Point, Axis, HingeAngle> {
 public:
  /// A hinge through a point of the world, about a direction of the world; the angle is zero at
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
