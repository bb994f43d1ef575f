// What a joint did to its bodies in the last step, as a force and a torque.
#pragma once

#include "engine/joint.h"

/// \addtogroup joint
/// @{
namespace joints {

/// A force and a torque. The torque is about a point that has to be said with it.
struct Reaction {
  vec3 force{0};   ///< [N], world
  vec3 torque{0};  ///< [N m], world
};

/// What the joint put on body 2 in the last step, the torque about body 2's centre; body 1 got the
/// opposite force at the same line. J^T lambda / h, summed over the live rows at the present poses.
/// Zero before the first step. Allocates: for looking at, not for the inner loop.
Reaction reaction(const Joint& joint, const Bodies& bodies);

}  // namespace joints
/// @}
