// Rods and ropes as joints of the engine. Given: there is nothing to edit here.
#pragma once

#include "chapters/01_distance/rods.h"
#include "joints/part_joint.h"

/// \addtogroup chapter1
/// @{
namespace joints {

/// Validates it. \throws std::invalid_argument unless the length is positive and finite
inline void check(const CentreDistance& rod) {
  require(finite(rod.length) && rod.length > 0, "length", rod.length,
          "of a rod it must be positive and finite [m]; for length 0 take a ball joint");
}
/// Validates it. \throws std::invalid_argument unless the length is positive, all finite
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

/// As in `world.add<CentreDistanceJoint>(a, b)`: the length is the present distance of the centres.
inline CentreDistance make(std::type_identity<CentreDistance>, const Body& body1,
                           const Body& body2) {
  return {length(body2.x - body1.x)};
}
/// The same with another length [m].
inline CentreDistance make(std::type_identity<CentreDistance>, const Body&, const Body&,
                           real length) {
  return {length};
}
/// As in `world.add<RopeJoint>(a, b, anchor, anchor, h)`: two points and a length.
/// \param point1 of body 1 [m, world] \param point2 of body 2 [m, world] \param length [m]
inline Distance make(std::type_identity<Distance>, const Body& body1, const Body& body2,
                     const vec3& point1, const vec3& point2, real length) {
  return {to_local(body1, point1 - body1.x), to_local(body2, point2 - body2.x), length};
}
/// The same with the present distance of the points as its length.
inline Distance make(std::type_identity<Distance> rod, const Body& body1, const Body& body2,
                     const vec3& point1, const vec3& point2) {
  return make(rod, body1, body2, point1, point2, length(point2 - point1));
}
/// The part of a rope takes the arguments of its rod.
template <class Rod, class... Arguments>
auto make(std::type_identity<Rope<Rod>>, const Body& body1, const Body& body2,
          const Arguments&... arguments)
    -> Rope<decltype(make(std::type_identity<Rod>{}, body1, body2, arguments...))> {
  return {make(std::type_identity<Rod>{}, body1, body2, arguments...)};
}

using CentreDistanceJoint = PartJoint<CentreDistance>;      ///< rod from centre to centre
using DistanceJoint = PartJoint<Distance>;                  ///< rod from anchor to anchor
using CentreRopeJoint = PartJoint<Rope<CentreDistance>>;    ///< rope from centre to centre
using RopeJoint = PartJoint<Rope<Distance>>;                ///< rope from anchor to anchor

}  // namespace joints
/// @}
