// The hinge of the engine: given, there is nothing to edit here.
#pragma once

#include "chapters/02_ball/ball_joint.h"
#include "chapters/03_hinge/driven_joint.h"

/// \addtogroup chapter3
/// @{
namespace joints {

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
