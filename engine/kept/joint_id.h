// Ids of joints, which are checked where a reference cannot be.
#pragma once

#include <cstdint>

#include "engine/world.h"

/// \addtogroup world
/// @{
namespace joints {

/// Identifies a joint of type J until it is removed: `JointId(world.add<HingeJoint>(a, b, anchor,
/// axis))` is that of a hinge. Unlike a reference it is checked: after the removal, and in another
/// world, it is rejected.
template <class J>
struct JointId {
  std::uint64_t number = 0;  ///< of all joints that were ever added; 0 identifies no joint

  JointId() = default;  ///< identifies no joint
  /// Of a joint that a world holds.
  JointId(const J& joint) : number(joint.number()) {}
  bool operator==(const JointId&) const = default;  ///< the same joint
};

/// The joint with this id.
/// \throws std::invalid_argument if it was removed or belongs to another world
template <class J>
J& World::operator[](JointId<J> id) const {
  const auto joint = dynamic_cast<J*>(find(id.number));
  require(joint != nullptr, no_such_joint);
  return *joint;
}
/// True if this id identifies a joint of this world.
template <class J>
bool World::alive(JointId<J> id) const { return find(id.number) != nullptr; }
/// Removes the joint with this id. \throws std::invalid_argument for a stale id
template <class J>
void World::remove(JointId<J> id) { remove((*this)[id]); }

}  // namespace joints
/// @}
