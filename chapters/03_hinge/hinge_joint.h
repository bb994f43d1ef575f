// The hinge of the engine: given, there is nothing to edit here.
#pragma once

#include "chapters/02_ball/ball_joint.h"
#include "chapters/03_hinge/driven_joint.h"

/// \addtogroup chapter3
/// @{
namespace joints {

/// An angle has turns.
inline void count_from(HingeAngle& angle, real expected) { angle.expected = expected; }

/// For an angle. Its rate is g.(w2 - w1) with |g| = 1/cos(s/2), where s is the angle between the
/// two axes (Eq. 3-10): while s stays below 83 degrees, |g| is below 1.34, and the angle changes by
/// less than 1.34 times the angle by which the bodies turn against each other. Half of the slack is
/// for what has been turned since the measuring, half for the step to come.
template <>
struct Leeway<HingeAngle> {
  /// See the general one.
  void measured(const HingeAngle& angle, const Body& body1, const Body& body2, real slack) {
    then_ = {angle.a1_local, angle.start};
    relative_ = conjugate(body1.q) * body2.q;
    const vec3 a2_local = relative_ * (conjugate(angle.start) * angle.a1_local);
    const bool aligned = dot(angle.a1_local, a2_local) > real(0.9);  // s below 26 degrees
    turn_ = aligned ? std::min(slack / real(2.7), real(0.9)) : real(0);
    // Of small angles float knows the cosine too badly: then every step measures.
    least_cosine_ = turn_ > real(0.01) ? std::cos(turn_ / 2) : real(2);
  }
  void forget() { least_cosine_ = 2; }  ///< measure next time in any case
  /// See the general one.
  bool still_near(const HingeAngle& angle, const Body& body1, const Body& body2) const {
    const quat was = body1.q * relative_;  // where body 2 would be, had the two not turned
    const real cosine = was.w * body2.q.w + was.x * body2.q.x + was.y * body2.q.y +
                        was.z * body2.q.z;  // of half the angle between was and is
    const quat& start = angle.start;
    const vec3& axis = angle.a1_local;
    return std::abs(cosine) > least_cosine_ && axis.x == then_.axis.x &&
           axis.y == then_.axis.y && axis.z == then_.axis.z && start.w == then_.start.w &&
           start.x == then_.start.x && start.y == then_.start.y && start.z == then_.start.z;
  }
  /// See the general one.
  bool is_slow(const Body& body1, const Body& body2, real h) const {
    const vec3 turning = h * (body2.w - body1.w);
    return least_cosine_ < 1 && dot(turning, turning) < turn_ * turn_;
  }

 private:
  // The geometry that was measured with: it may be changed between steps.
  struct Geometry {
    vec3 axis{0};
    quat start{1, 0, 0, 0};
  };
  Geometry then_;
  quat relative_{1, 0, 0, 0};  // q1^-1 q2 when the angle was measured
  real turn_ = 0;              // how far the bodies may turn, before and again in a step [rad]
  real least_cosine_ = 2;      // cos(turn_/2); above 1: measure
};

/// A hinge: a point and an axis are held (five degrees of freedom), the angle about the axis stays
/// free and may have limits [rad] and a motor [rad/s, N m].
class HingeJoint : public DrivenJoint<Point, Axis, HingeAngle> {
 public:
  /// A hinge through a point of the world, about a direction of the world; the angle is zero as
  /// the bodies stand now. \param anchor [m] \param axis of any length
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
