// The parts of chapter 4 with their errors written out once more: J is compared with the slopes of
// these, so that it waits for no C of the reader's.
#pragma once

#include "tests/checker/joint_fixtures.h"

namespace joints::testing {

// p2 - p1.
template <class Part>
vec3 gap(const Part& part, const Body& body1, const Body& body2) {
  return body2.x + body2.q * part.anchor2_local - body1.x - body1.q * part.anchor1_local;
}
// The vector of a rotation, from the one of q and -q that turns less.
inline vec3 short_way(const quat& q) {
  return (q.w < 0 ? real(-1) : real(1)) * vec3(q.x, q.y, q.z);
}
// 2 sin(angle / 2) times the axis of a rotation, from its matrix.
inline vec3 twice_half_sine(const mat3& R) {
  const vec3 twice_sine(R[1].z - R[2].y, R[2].x - R[0].z, R[0].y - R[1].x);
  return twice_sine / std::sqrt(1 + R[0].x + R[1].y + R[2].z);
}

struct LineReference : Line {
  Vector<2> error(const Body& body1, const Body& body2) const {
    const vec3 u = conjugate(body1.q) * gap(*this, body1, body2);
    return {dot(u, n1_local), dot(u, n2_local)};
  }
};
struct LockReference : RotationLock {
  vec3 error(const Body& body1, const Body& body2) const {
    return twice_half_sine(glm::mat3_cast(body2.q) * transpose(glm::mat3_cast(body1.q * start)));
  }
};
struct SlideReference : Slide {
  real error(const Body& body1, const Body& body2) const {
    return dot(gap(*this, body1, body2), body1.q * a1_local);
  }
};

template <class Fixture, class Reference>
struct WithReference : Fixture {
  using Part = Reference;
  static Part make(const Pair& pair) { return {Fixture::make(pair)}; }
};
using Lines = WithReference<LineFixture, LineReference>;
using Locks = WithReference<RotationLockFixture, LockReference>;
using Slides = WithReference<SlideFixture, SlideReference>;

}  // namespace joints::testing
