// Rods and ropes as joints of the engine. Given: there is nothing to edit here.
#pragma once

#include "chapters/01_distance/distance.h"
#include "engine/part_joint.h"

/// \addtogroup chapter1
/// @{
namespace joints {

/// \throws std::invalid_argument unless the length is positive and finite
inline void check(const CentreDistance& rod) {
  require(finite(rod.length) && rod.length > 0, "length", rod.length,
          "of a rod it must be positive and finite [m]; for length 0 take a ball joint");
}
/// \throws std::invalid_argument unless the length is positive and finite, the anchors finite
inline void check(const Distance& rod) {
  check(CentreDistance{rod.length});
  if (finite(sum(rod.anchor1_local) + sum(rod.anchor2_local))) return;
  require_finite("anchor1_local", rod.anchor1_local, "must be finite [m]");
  require_finite("anchor2_local", rod.anchor2_local, "must be finite [m]");
}
/// A rope may have length 0. \throws std::invalid_argument otherwise as for a rod
template <class Rod>
void check(const Rope<Rod>& rope) {
  Rod rod = rope.rod;
  if (rod.length == 0) rod.length = 1;
  check(rod);
}

using CentreDistanceJoint = PartJoint<CentreDistance>;      ///< rod from centre to centre
using DistanceJoint = PartJoint<Distance>;                  ///< rod from anchor to anchor
using CentreRopeJoint = PartJoint<Rope<CentreDistance>>;    ///< rope from centre to centre
using RopeJoint = PartJoint<Rope<Distance>>;                ///< rope from anchor to anchor

}  // namespace joints
/// @}
