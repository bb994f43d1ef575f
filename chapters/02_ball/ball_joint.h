// The ball joint of the engine: given, there is nothing to edit here.
#pragma once

#include "chapters/02_ball/ball.h"
#include "engine/part_joint.h"

/// \addtogroup chapter2
/// @{
namespace joints {

/// \throws std::invalid_argument unless both anchors are finite
inline void check(const Point& point) {
  require(finite(point.anchor1_local), "anchor1_local: must be finite [m]");
  require(finite(point.anchor2_local), "anchor2_local: must be finite [m]");
}

using BallJoint = PartJoint<Point>;  ///< ball and socket

}  // namespace joints
/// @}
