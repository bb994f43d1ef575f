// The world: bodies, joints, gravity, and the blocks of its last step. It does not depend on any
// particular joint or solver.
#pragma once

#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/joint.h"

/// \defgroup world World and step
/// \brief The parts of a simulation, the step that advances it, and the solvers.
/// @{
namespace joints {

/// Identifies a joint of type J until it is removed: `JointId(world.add<HingeJoint>(a, b, anchor,
/// axis))` is that of a hinge. Unlike a reference it is checked: after the removal, and in another
/// world, it is rejected.
template <class J = Joint>
struct JointId {
  std::uint64_t number = 0;  ///< of all joints that were ever added; 0 identifies no joint

  JointId() = default;  ///< identifies no joint
  /// Of a joint that a world holds.
  JointId(const J& joint) : number(joint.number()) {}
  bool operator==(const JointId&) const = default;  ///< the same joint
};

/// Bodies, the joints between them, and gravity. Anything may be added, removed or changed
/// between two steps.
class World {
 public:
  Bodies bodies;  ///< all bodies; use World::remove() to remove one together with its joints
  vec3 gravity{0, real(-9.81), 0};  ///< [m/s^2]
  Blocks blocks;  ///< the blocks of the last step; empty after a body or joint was removed
  real last_h = 0;                  ///< length of the last (sub)step [s]; 0 before the first
  /// The longest displacement of a body's centre by one block in one iteration of position
  /// projection [m], positive. The default is for bodies of about 1 m; for others use a fifth of
  /// their size.
  real max_displacement = real(0.2);

  /// Adds a body. \throws std::invalid_argument as Bodies::add()
  BodyId add(const Body& body) { return bodies.add(body); }
  /// Removes a body and every joint that is connected to it.
  void remove(BodyId body);

  /// Constructs a joint of type J between two bodies from these arguments and adds it, as in
  /// `world.add<HingeJoint>(a, b, anchor, axis)`. If a constructor of J needs the bodies, the world
  /// passes them as its first argument.
  /// \return the joint, valid until it or one of its bodies is removed. A JointId is checked.
  /// \throws std::invalid_argument from its constructor or Joint::check_input()
  template <class J, class... Arguments>
  J& add(Arguments&&... arguments) {
    std::unique_ptr<J> joint;
    if constexpr (std::is_constructible_v<J, const Bodies&, Arguments...>)
      joint = std::make_unique<J>(std::as_const(bodies), std::forward<Arguments>(arguments)...);
    else
      joint = std::make_unique<J>(std::forward<Arguments>(arguments)...);
    J& reference = *joint;
    adopt(std::move(joint));
    return reference;
  }
  /// The same with the bodies as the first argument, which the world passes by itself.
  template <class J, class... Arguments>
    requires std::is_constructible_v<J, const Bodies&, Arguments...>
  [[deprecated("the world passes its bodies: write world.add<J>(body1, body2, ...)")]]
  J& add(Bodies&, Arguments&&... arguments) {
    return add<J>(std::forward<Arguments>(arguments)...);
  }
  /// Removes one joint, in constant time. \throws std::invalid_argument if it does not belong to
  /// this world
  void remove(const Joint& joint);
  /// The joint with this id.
  /// \throws std::invalid_argument if it was removed or belongs to another world
  template <class J>
  J& operator[](JointId<J> id) const {
    const auto joint = dynamic_cast<J*>(find(id.number));
    require(joint != nullptr, no_such_joint);
    return *joint;
  }
  /// True if this id identifies a joint of this world.
  template <class J>
  bool alive(JointId<J> id) const { return find(id.number) != nullptr; }
  /// Removes the joint with this id. \throws std::invalid_argument for a stale id
  template <class J>
  void remove(JointId<J> id) { remove((*this)[id]); }
  /// Sets beta of all present joints. \param beta fraction of the error that is removed in a step
  /// [1] \throws std::invalid_argument unless it is from 0 to max_beta
  void set_beta(real beta);

  /// The joints in the order in which they were added, which is the order of their blocks. A loop
  /// over them may remove joints and bodies; those that it has removed stay in this list until the
  /// next call, but take no part in anything.
  const std::vector<std::unique_ptr<Joint>>& joints() const {
    if (holes_) close_holes();
    return joints_;
  }

 private:
  static constexpr const char* no_such_joint =
      "joint: this world has no such joint (removed, or of another one)";
  void adopt(std::unique_ptr<Joint> joint);
  Joint* find(std::uint64_t number) const;  // nullptr if it is not there
  void close_holes() const {
    std::erase_if(joints_, [](const auto& joint) { return joint->removed_; });
    for (std::size_t k = 0; k < joints_.size(); ++k) joints_[k]->place_ = k;
    holes_ = false;
  }
  mutable std::vector<std::unique_ptr<Joint>> joints_;
  mutable bool holes_ = false;  // some of them were removed
};

}  // namespace joints
/// @}
