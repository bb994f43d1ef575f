// The world: bodies, joints, gravity, and the blocks of its last step. It does not depend on any
// particular joint or solver.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/joint.h"

/// \defgroup world World and step
/// \brief The parts of a simulation, the step that advances it, and the solvers.
/// @{
namespace joints {

template <class J = Joint>
struct JointId;  // engine/kept/joint_id.h

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

  World() = default;                    ///< without bodies
  World(World&&) = default;             ///< its joints stay where they are
  World& operator=(World&&) = default;  ///< its joints stay where they are
  World(const World&) = delete;  ///< a World is not copied: build another one, restore(it, save(w))

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
    else if constexpr (std::is_constructible_v<J, Arguments...>)
      joint = std::make_unique<J>(std::forward<Arguments>(arguments)...);
    else
      static_assert(!sizeof(J), "world.add<J>(body1, body2, ...): J has no constructor with these "
                    "arguments (its header lists them), or J lacks a function such as append()");
    J& reference = *joint;
    adopt(std::move(joint));
    return reference;
  }
  /// Its form before version 0.10.
  template <class J, class... Arguments>
    requires std::is_constructible_v<J, const Bodies&, Arguments...>
  [[deprecated("the world passes its bodies: write world.add<J>(body1, body2, ...)")]]
  J& add(Bodies&, Arguments&&... arguments) {
    return add<J>(std::forward<Arguments>(arguments)...);
  }
  /// Removes one joint; the next joints() closes its place.
  /// \throws std::invalid_argument if it is of another world
  void remove(const Joint& joint);
  // By an id that is checked (engine/kept/joint_id.h):
  template <class J> J& operator[](JointId<J> id) const;
  template <class J> bool alive(JointId<J> id) const;
  template <class J> void remove(JointId<J> id);
  /// Sets Joint::beta [1] of all present joints. \throws std::invalid_argument as check_beta()
  void set_beta(real beta);

  /// The joints in the order in which they were added, in which they append their blocks. A loop
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
