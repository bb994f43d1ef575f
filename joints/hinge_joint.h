// The hinge of the engine. Given: there is nothing to edit here.
#pragma once

#include "chapters/02_ball/ball.h"
#include "joints/driven_joint.h"

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
