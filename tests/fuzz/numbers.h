// All numbers of bodies and joints that anybody may change between two steps.
#pragma once

#include <vector>

#include "contacts/ground_contact.h"
#include "joints/distance_joint.h"
#include "joints/fixed_joint.h"
#include "joints/hinge_joint.h"

namespace joints::testing {

/// Where the numbers stand.
using Addresses = std::vector<real*>;

inline void take(Addresses& out, real& a) { out.push_back(&a); }
inline void take(Addresses& out, vec3& a) { for (int k = 0; k < 3; ++k) out.push_back(&a[k]); }
inline void take(Addresses& out, quat& q) { out.insert(out.end(), {&q.w, &q.x, &q.y, &q.z}); }
inline void take(Addresses& out, CentreDistance& rod) { take(out, rod.length); }
inline void take(Addresses& out, Distance& rod) {
  take(out, rod.anchor1_local), take(out, rod.anchor2_local), take(out, rod.length);
}
template <class Rod>
void take(Addresses& out, Rope<Rod>& rope) { take(out, rope.rod); }
inline void take(Addresses& out, Point& p) {
  take(out, p.anchor1_local), take(out, p.anchor2_local);
}
inline void take(Addresses& out, Axis& a) {
  take(out, a.a1_local), take(out, a.b_local), take(out, a.c_local);
}
inline void take(Addresses& out, Line& a) {
  take(out, a.anchor1_local), take(out, a.anchor2_local), take(out, a.n1_local);
  take(out, a.n2_local);
}
inline void take(Addresses& out, RotationLock& lock) { take(out, lock.start); }
inline void take(Addresses& out, Top& top) {
  take(out, top.height), take(out, top.half_x), take(out, top.half_z), take(out, top.depth);
}
template <class Part>
void take(Addresses& out, PartJoint<Part>& joint) { take(out, joint.part); }
template <class First, class Second, class Coordinate>
void take(Addresses& out, DrivenJoint<First, Second, Coordinate>& joint) {
  take(out, joint.first), take(out, joint.second);
}
inline void take(Addresses& out, FixedJoint& joint) {
  take(out, joint.weld.first), take(out, joint.weld.second);
}
inline void take(Addresses& out, GroundContact& joint) {
  take(out, joint.top), take(out, joint.friction), take(out, joint.restitution);
  take(out, joint.threshold);
}
inline void take(Addresses& out, Body& body) {
  for (vec3* const a : {&body.x, &body.v, &body.w, &body.inverse_inertia_local, &body.force,
                        &body.torque})
    take(out, *a);
  take(out, body.q), take(out, body.inverse_mass);
}

template <class... Kinds>
void take_kinds(Addresses& out, Joint& joint) {
  const auto look = [&]<class Kind>(Kind* one) {
    if (one) take(out, *one);
  };
  (look(dynamic_cast<Kinds*>(&joint)), ...);
}
inline void take(Addresses& out, Joint& joint) {
  take(out, joint.beta);
  take_kinds<CentreDistanceJoint, DistanceJoint, CentreRopeJoint, RopeJoint, BallJoint, HingeJoint,
             SliderJoint, FixedJoint, GroundContact>(out, joint);
}

}  // namespace joints::testing
