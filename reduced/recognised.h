// A joint as a chain of elementary motions. Given, there is nothing to edit here.
#pragma once

#include "joints/driven_joints.h"
#include "reduced/tree.h"

/// \addtogroup reduced
/// @{
namespace joints {

/// One hinge, slider, ball or weld of a joint.
struct Element {
  Freedom freedom = Freedom::weld;  ///< of its second frame in the first one
  vec3 axis{0};                  ///< unit, in the space of the first frame
  quat start{1, 0, 0, 0};        ///< orientation of the second frame in the first at coordinate 0
  CoordinateSource source{};     ///< of a hinge or a slider
};

/// A joint as elementary motions from body 1 to body 2. All frames between are at its anchor.
struct Recognised {
  vec3 anchor1_local{0};  ///< [m, body space]
  vec3 anchor2_local{0};  ///< [m, body space]
  std::vector<Element> elements{};  ///< at least one

  /// The same from body 2 to body 1, with the same coordinates.
  Recognised reversed() const;
};

/// Recognises a joint. \param number of the joint, for the message
/// \throws std::invalid_argument naming it if it has no elementary motions
Recognised recognise(const Joint& joint, std::size_t number);
/// The locks of a joint with six degrees of freedom; infinite ranges for the others.
std::array<Range, 6> locks_of(const SixDofJoint& joint);
/// True if limits, drives or bounds act on a joint.
bool is_driven(const Joint& joint);
/// Rejects a joint. \param why continues "joint 3 (HingeJoint) " \throws std::invalid_argument
[[noreturn]] void refuse_joint(const Joint& joint, std::size_t number, const std::string& why);

}  // namespace joints
/// @}
