// The fixed joint of the engine: given, there is nothing to edit here.
#pragma once

#include "chapters/05_fixed/fixed.h"
#include "joints/ball_joint.h"
#include "joints/slider_joint.h"

/// \addtogroup chapter5
/// @{
namespace joints {

/// A fixed joint, or weld: removes all relative motion of two bodies. C and J: Eq. 5-1; the blocks
/// of K: Eq. 2-6 and Eq. 4-9 on the diagonal, Eq. 5-2 off the diagonal.
class FixedJoint : public Joint {
 public:
  Weld weld;          ///< the geometry; may be changed between steps
  bool whole = true;  ///< solve one block of six rows; false: two blocks of three

  /// Holds two bodies at their present relative pose. \param anchor common point [m, world]
  /// \throws std::invalid_argument unless the anchor is finite
  FixedJoint(const Bodies& bodies, BodyId id1, BodyId id2, const vec3& anchor)
      : Joint(id1, id2), weld{point_at(bodies[id1], bodies[id2], anchor),
                              lock_of(bodies[id1], bodies[id2])} {
    check(weld.first);
  }
  /// The bodies, beta, both parts by their check(), and the anchors by check_lever().
  void check_input(const Bodies& bodies) const override {
    Joint::check_input(bodies);
    check(weld.first);
    check(weld.second);
    check_lever("anchor1_local", bodies.at(int(body1.slot)), weld.first.anchor1_local);
    check_lever("anchor2_local", bodies.at(int(body2.slot)), weld.first.anchor2_local);
  }
  void append(const Bodies& bodies, Blocks& blocks) const override {
    const RowSettings target = hold();
    if (whole) {
      blocks.append(bodies, body1, body2, weld, target, impulse_.data());
    } else {
      blocks.append(bodies, body1, body2, weld.first, target, impulse_.data());
      blocks.append(bodies, body1, body2, weld.second, target, impulse_.data() + 3);
    }
  }

  /// Force on body 2 and torque on it about the anchor in the last step, exercise 5.2.
  Reaction load() const {
    return impulse_duration() > 0 ? carried(impulse_, impulse_duration()) : Reaction{};
  }
  /// The same about another point, for example the middle of the seam whose strength is known. The
  /// result does not depend on the anchor. \param point [m, world]
  Reaction load(const Bodies& bodies, const vec3& point) const {
    return about(load(), world_point(bodies[body2], weld.first.anchor2_local), point);
  }

 protected:
  void serialize(StateStream& stream) override { stream(impulse_); }

 private:
  mutable Vector<6> impulse_{};  // written by the solver through the blocks
};

}  // namespace joints
/// @}
