// Chapter 3: hinge, limit, motor. Replace each todo(...) with your own code. README.md has the
// text.
#include "chapters/03_hinge/hinge.h"

#include <algorithm>
#include <numbers>

#include "engine/instruments/todo.h"

namespace joints {

// ---- the two rows that hold the axis --------------------------------------------------------

Vector<2> Axis::error(const Body& body1, const Body& body2) const {
  const vec3 a1 = to_world(body1, a1_local);
  const vec3 b = to_world(body2, b_local), c = to_world(body2, c_local);
  if (far_off(a1, b, c)) return far_error(a1, b, c);
  // begin [exercise 3.1]
  // Return the two numbers C of Eq. 3-2, made of a1, b and c above: `return {first, second};`.
  todo("3.1");
  // end [exercise 3.1]
}

Jacobian<2> Axis::jacobian(const Body& body1, const Body& body2) const {
  vec3 a1 = to_world(body1, a1_local);
  const vec3 b = to_world(body2, b_local), c = to_world(body2, c_local);
  if (far_off(a1, b, c)) a1 = cross(b, c);  // for the rows of far_error
  // begin [exercise 3.1]
  // Return the two rows J of Eq. 3-4, made of a1, b and c above. A row is Row{v1, w1, v2, w2}.
  // Write vec3(0) for a block that is zero.
  todo("3.1");
  // end [exercise 3.1]
}

Matrix<2> Axis::K(const Body& body1, const Body& body2) const {
  const Jacobian<2> J = jacobian(body1, body2);
  const mat3 I = inverse_inertia(body1) + inverse_inertia(body2);
  const vec3 B1 = J[0].w2, B2 = J[1].w2;  // the two rows of B
  return {{{{dot(B1, I * B1), dot(B1, I * B2)}, {dot(B2, I * B1), dot(B2, I * B2)}}}};  // Eq. 3-6
}

Vector<2> Axis::far_error(const vec3& a1, const vec3& b, const vec3& c) {
  const vec3 a2 = cross(b, c), across = cross(a1, a2);
  const real sine = length(across);
  const vec3 about = sine > 0 ? across / sine : b;  // for opposite axes any perpendicular axis
  const vec3 phi = std::atan2(sine, dot(a1, a2)) * about;
  return {-dot(phi, c), dot(phi, b)};  // Eq. 3-7
}

// The unit vector along an axis of any length. It is scaled first, because squares may overflow.
static vec3 unit(const vec3& axis) {
  const real size = std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)});
  require(finite(axis) && size > 0, "axis: must be finite and not zero");
  return normalize(axis / size);
}

Axis axis_along(const Body& body1, const Body& body2, const vec3& axis) {
  const vec3 world = unit(axis);
  const vec3 a = normalize(to_local(body2, world));
  const int least = std::abs(a.x) <= std::abs(a.y) ? (std::abs(a.x) <= std::abs(a.z) ? 0 : 2)
                                                   : (std::abs(a.y) <= std::abs(a.z) ? 1 : 2);
  vec3 other(0);
  other[least] = 1;
  const vec3 b = normalize(cross(a, other));
  return {normalize(to_local(body1, world)), b, cross(a, b)};
}

real coupling(const Row& a, const Row& b, const Body& body1, const Body& body2) {
  // begin [exercise 3.2]
  // Return a M^-1 b^T, Eq. 3-8. M^-1 divides the linear vectors by the mass of their body and
  // multiplies the angular ones by its inverse inertia. inverse_inertia(body) is in world axes.
  todo("3.2");
  // end [exercise 3.2]
}

// ---- the angle ------------------------------------------------------------------------------

real HingeAngle::twist(const Body& body1, const Body& body2) const {
  // begin [exercise 3.3]
  // Return the angle of Eq. 3-9, in [-pi, pi]. The member `start` is q_start. conjugate(q) is q^-1
  // of a unit quaternion. The parts of q are q.w and the vector (q.x, q.y, q.z). std::atan2(p, s)
  // is the angle of (s, p).
  todo("3.3");
  // end [exercise 3.3]
}

real unwrapped(real measured, real expected) {
  // begin [exercise 3.3]
  // Return measured + 2 pi k with the integer k that brings it nearest to expected.
  // std::remainder(x, y) is x minus the nearest multiple of y.
  todo("3.3");
  // end [exercise 3.3]
}

Row HingeAngle::jacobian(const Body& body1, const Body& body2) const {
  const vec3 a1 = to_world(body1, a1_local);
  const vec3 a2 = to_world(body2, conjugate(start) * a1_local);
  const real divisor = 1 + dot(a1, a2);
  const vec3 g = divisor > real(0.05) ? (a1 + a2) / divisor : a1;  // Eq. 3-10
  return {vec3(0), -g, vec3(0), g};
}

real HingeAngle::K(const Body& body1, const Body& body2) const {
  const vec3 g = jacobian(body1, body2).w2;
  return dot(g, (inverse_inertia(body1) + inverse_inertia(body2)) * g);  // Eq. 3-11
}

HingeAngle angle_about(const Body& body1, const Body& body2, const vec3& axis) {
  return {normalize(to_local(body1, unit(axis))), normalize(conjugate(body1.q) * body2.q), 0};
}

// ---- limit and motor ------------------------------------------------------------------------

LimitRow limit_row(const Range& range, real x, real rate, real h) {
  // begin [exercise 3.4]
  // Return {C, sign, live} of the limit with the smaller gap at the end of this step, Eq. 3-13.
  // C = x - lower grows with x (sign +1), and C = upper - x shrinks with x (sign -1). The limit is
  // live if C < h |rate| + 0.1 h, Eq. 3-14.
  todo("3.4");
  // end [exercise 3.4]
}

real motor_impulse(real rate, real K, const Motor& motor, real h, real& sum) {
  // begin [exercise 3.5]
  // The sum that would reach motor.speed at once is Eq. 3-15. Clamp it to +-h motor.strength,
  // Eq. 3-16. Store it in `sum` and return its change.
  todo("3.5");
  // end [exercise 3.5]
}

}  // namespace joints
