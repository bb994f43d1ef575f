// Whether a hinge can have come near its limits since its angle was measured: a few products in the
// place of an arc tangent. Given, there is nothing to edit here.
#pragma once

#include <algorithm>

#include "chapters/03_hinge/hinge.h"

/// \addtogroup chapter3
/// @{
namespace joints {

/// Saves the measuring of a coordinate while the room to its limits cannot have been used up. In
/// general it saves nothing: the coordinate is measured in every step.
template <class Coordinate>
struct Leeway {
  /// The coordinate was measured just now. \param room to the nearer limit [rad or m]
  void measured(const Coordinate&, const Body&, const Body&, [[maybe_unused]] real room) {}
  void forget() {}  ///< measure next time in any case
  /// The bodies' poses are still near those at which it was measured.
  bool still_near(const Coordinate&, const Body&, const Body&) const { return false; }
  /// This step cannot use up the room. \param h step [s]
  bool is_slow(const Body&, const Body&, [[maybe_unused]] real h) const { return false; }
};

/// For an angle. Its rate is g.(w2 - w1) with |g| = 1/cos(s/2), where s is the angle between the
/// two axes (Eq. 3-10): while s stays below 83 degrees, |g| is below 1.34, and the angle changes by
/// less than 1.34 times the angle by which the bodies turn against each other. Half of the room is
/// for what has been turned since the measuring, half for the step to come.
template <>
struct Leeway<HingeAngle> {
  /// See the general one.
  void measured(const HingeAngle& angle, const Body& body1, const Body& body2, real room) {
    then_ = {angle.a1_local, angle.start};
    relative_ = conjugate(body1.q) * body2.q;
    const vec3 a2_local = relative_ * (conjugate(angle.start) * angle.a1_local);
    const bool aligned = dot(angle.a1_local, a2_local) > real(0.9);  // s below 26 degrees
    turn_ = aligned ? std::min(room / real(2.7), real(0.9)) : real(0);
    // Of small angles float knows the cosine too badly: then every step measures.
    least_cosine_ = turn_ > real(0.01) ? std::cos(turn_ / 2) : real(2);
  }
  void forget() { least_cosine_ = 2; }  ///< measure next time in any case
  /// See the general one.
  bool still_near(const HingeAngle& angle, const Body& body1, const Body& body2) const {
    const quat was = body1.q * relative_;  // where body 2 would be, had the two not turned
    const real cosine = was.w * body2.q.w + was.x * body2.q.x + was.y * body2.q.y +
                        was.z * body2.q.z;  // of half the angle between was and is
    const quat& start = angle.start;
    const vec3& axis = angle.a1_local;
    return std::abs(cosine) > least_cosine_ && axis.x == then_.axis.x &&
           axis.y == then_.axis.y && axis.z == then_.axis.z && start.w == then_.start.w &&
           start.x == then_.start.x && start.y == then_.start.y && start.z == then_.start.z;
  }
  /// See the general one.
  bool is_slow(const Body& body1, const Body& body2, real h) const {
    const vec3 turning = h * (body2.w - body1.w);
    return least_cosine_ < 1 && dot(turning, turning) < turn_ * turn_;
  }

 private:
  // The geometry that was measured with: it may be changed between steps.
  struct Geometry {
    vec3 axis{0};
    quat start{1, 0, 0, 0};
  };
  Geometry then_;
  quat relative_{1, 0, 0, 0};  // q1^-1 q2 when the angle was measured
  real turn_ = 0;              // how far the bodies may turn, before and again in a step [rad]
  real least_cosine_ = 2;      // cos(turn_/2); above 1: measure
};

}  // namespace joints
/// @}
