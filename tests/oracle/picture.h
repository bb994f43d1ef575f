// All bits of a world, to see that nothing in it has changed: also what no test may name, such as
// the turns that a hinge has counted.
#pragma once

#include <cstddef>
#include <string>

#include "contacts/ground_contact.h"
#include "engine/world.h"
#include "joints/distance_joint.h"
#include "joints/fixed_joint.h"
#include "joints/hinge_joint.h"

namespace joints::testing {

/// The bytes of one object; a joint keeps everything in itself.
template <class T>
std::string bytes_of(const T& object) {
  return {reinterpret_cast<const char*>(&object), sizeof object};
}

/// Those of a body's numbers: bytes without a meaning follow them.
inline std::string bytes_of(const Body& body) {
  return {reinterpret_cast<const char*>(&body), offsetof(Body, kinematic) + sizeof body.kinematic};
}

/// Those of a joint if it is of one of these kinds, the bytes of a general joint if of none.
template <class... Kinds>
std::string bytes_of_kinds(const Joint& joint) {
  std::string out = bytes_of(joint);
  const auto look = [&]<class Kind>(const Kind* one) {
    if (one) out = bytes_of(*one);
  };
  (look(dynamic_cast<const Kinds*>(&joint)), ...);
  return out;
}

inline std::string bits_of(const Joint& joint) {
  return bytes_of_kinds<CentreDistanceJoint, DistanceJoint, CentreRopeJoint, RopeJoint, BallJoint,
                        HingeJoint, SliderJoint, FixedJoint, GroundContact>(joint);
}

/// Bodies, joints, gravity, the blocks of the last step and its length.
inline std::string bits_of(const World& world) {
  std::string out = bytes_of(world.gravity) + bytes_of(world.last_h);
  for (int slot = 0; slot < world.bodies.slots(); ++slot)
    out += char(world.bodies.used(slot)) + bytes_of(world.bodies.at(slot));
  for (const auto& joint : world.joints()) out += bits_of(*joint);
  for (const Block& block : world.blocks.list) out += bytes_of(block);
  for (int row = 0; row < world.blocks.rows(); ++row) out += bytes_of(world.blocks.J[row]);
  for (const real& error : world.blocks.C) out += bytes_of(error);
  return out;
}

}  // namespace joints::testing
