// The ball joint of the engine. Given: there is nothing to edit here.
#pragma once

#include "chapters/02_ball/ball.h"
#include "joints/part_joint.h"

/// \addtogroup chapter2
/// @{
namespace joints {

/// PartJoint calls it for `world.add<BallJoint>(a, b, anchor)`.
/// \param anchor common point [m, world]
inline Point make(std::type_identity<Point>, const Body& body1, const Body& body2,
                  const vec3& anchor) {
  return point_at(body1, body2, anchor);
}

using BallJoint = PartJoint<Point>;  ///< ball-and-socket joint

}  // namespace joints
/// @}
