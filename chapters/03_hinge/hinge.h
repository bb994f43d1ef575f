// Chapter 3: hinge, limit, motor. Declares the functions that hinge.cpp has to define. Read
// README.md in this folder first. Given: there is nothing to edit here.
#pragma once

#include "engine/block.h"

/// \defgroup chapter3 Chapter 3: hinge
/// \brief Two rows that hold an axis, the angle about it, its limits and its motor.
/// @{
namespace joints {

// ---- the two rows that hold the axis --------------------------------------------------------

/// Keeps an axis of body 1 along an axis of body 2. Removes two degrees of freedom.
///
/// a1 = R1 a1_local; b, c = R2 b_local, R2 c_local, both perpendicular to body 2's axis a2 = b x c.
/// C = (a1.b, a1.c) [1]; J of Eq. 3-4 is exact because b and c are fixed in body 2; K is Eq. 3-6
/// [1/(kg m^2)]. At 90 degrees K is singular, and at 180 degrees C is zero again. Beyond 60 degrees
/// the part therefore uses the vector of the shortest rotation from a1 to a2 [rad], for which J is
/// exact only near alignment. Source: thesis, section 3.7.3; the rotation vector is ours.
/// In other engines `Axis` often denotes a translation axis; here it is a rotation axis.
struct Axis {
  vec3 a1_local{1, 0, 0};  ///< the axis, unit, body space of body 1
  vec3 b_local{0, 1, 0};   ///< unit, perpendicular to body 2's axis, body space of body 2
  vec3 c_local{0, 0, 1};   ///< unit, perpendicular to that axis and to b, body space of body 2

  static constexpr int rows = 2;            ///< degrees of freedom that it removes
  static constexpr bool one_sided = false;  ///< both signs of impulse are allowed
  static constexpr Form form = Form::angular;  ///< the form of its rows
  Vector<2> error(const Body& body1, const Body& body2) const;       ///< exercise 3.1 [1]
  Jacobian<2> jacobian(const Body& body1, const Body& body2) const;  ///< exercise 3.1
  /// Eq. 3-6 [1/(kg m^2)].
  Matrix<2> K(const Body& body1, const Body& body2) const;

  /// True if the axes are more than 60 degrees apart. Then far_error() is used.
  /// \param a1 the axis of body 1 \param b, c of body 2; all unit, world
  static bool far_off(const vec3& a1, const vec3& b, const vec3& c) {
    return dot(a1, cross(b, c)) < real(0.5);
  }
  /// C from the vector of the shortest rotation from a1 to a2 [rad]. It has no false zero at 180
  /// degrees. \param a1, b, c as in far_off()
  static Vector<2> far_error(const vec3& a1, const vec3& b, const vec3& c);
};

/// Makes the part that keeps this world direction aligned in both bodies, from their present poses.
/// \throws std::invalid_argument unless the axis is finite and not zero
Axis axis_along(const Body& body1, const Body& body2, const vec3& axis);

/// Exercise 3.2: one entry of K = J M^-1 J^T, the rate of row a caused by an impulse of 1 along
/// row b. \return a M^-1 b^T [1/kg, 1/(kg m) or 1/(kg m^2), depending on the units of the rows]
real coupling(const Row& a, const Row& b, const Body& body1, const Body& body2);

#ifndef JOINTS_LIBRARY  // exercises, which programs that link the library do not see
/// K = J M^-1 J^T of any N rows, computed entry by entry with coupling().
template <int N>
Matrix<N> K_of(const Jacobian<N>& J, const Body& body1, const Body& body2) {
  Matrix<N> K;
  for (int i = 0; i < N; ++i)
    for (int j = i; j < N; ++j) K[i][j] = K[j][i] = coupling(J[i], J[j], body1, body2);
  return K;
}
#endif

// ---- the angle ------------------------------------------------------------------------------

/// Exercise 3.3, second half: of all angles that equal `measured` modulo 2 pi, the one nearest to
/// `expected`. \param measured [rad] \param expected [rad]
real unwrapped(real measured, real expected);

/// The angle of body 2 relative to body 1 about the hinge's axis, measured from `start`. Limit and
/// motor use its row. Positive by the right-hand rule about the axis.
///
/// q_d = q1^-1 q2 start^-1 = (s, v), negated if s < 0; p = v.a1_local;
/// C = 2 atan2(p, s) plus the multiple of 2 pi that brings it to within half a turn of `expected`
/// [rad]; J = (0, -g, 0, g), g = (a1 + a2)/(1 + a1.a2), exact at every misalignment below 180
/// degrees (close to 180 degrees g = a1 is used); K = g.(I1^-1 + I2^-1) g [1/(kg m^2)].
/// Source: thesis, section 3.7.3, corrected: the twist of the relative rotation (swing-twist
/// decomposition), in body 1's frame.
struct HingeAngle {
  vec3 a1_local{1, 0, 0};   ///< the axis, unit, body space of body 1
  quat start{1, 0, 0, 0};   ///< q1^-1 q2 where the angle is zero
  real expected = 0;        ///< error() is within half a turn of this [rad]

  static constexpr int rows = 1;            ///< one row, used by limit and motor
  static constexpr bool one_sided = false;  ///< false; the row of a limit is one-sided
  static constexpr Form form = Form::angular;  ///< the form of its row
  real twist(const Body& body1, const Body& body2) const;  ///< exercise 3.3, in [-pi, pi] [rad]
  /// C, the angle including whole turns [rad].
  real error(const Body& body1, const Body& body2) const {
    return unwrapped(twist(body1, body2), expected);
  }
  Row jacobian(const Body& body1, const Body& body2) const;  ///< Eq. 3-10
  real K(const Body& body1, const Body& body2) const;        ///< Eq. 3-11 [1/(kg m^2)]
};

/// Makes the angle that is zero at the bodies' present poses. \param axis world, of any length
/// \throws std::invalid_argument unless the axis is finite and not zero
HingeAngle angle_about(const Body& body1, const Body& body2, const vec3& axis);

// ---- limit and motor, of an angle or a displacement -----------------------------------------

/// The limits of the free coordinate x of a joint: an angle [rad] or a displacement [m].
struct Range {
  real lower = -unbounded;  ///< least value; infinite for no limit
  real upper = unbounded;   ///< greatest value; infinite for no limit
};

/// The limit that may need a row in this step.
struct LimitRow {
  real C = unbounded;  ///< gap to the limit, negative beyond it [rad or m]
  real sign = 1;       ///< dC/dx: +1 at the lower limit, -1 at the upper one
  bool live = false;   ///< true if it needs a row in this step
};

/// Exercise 3.4: the limit that has the smaller gap at the end of this step.
/// \param x the coordinate now [rad or m] \param rate dx/dt [rad/s or m/s] \param h step [s]
/// \return its present gap, its sign, and whether it is near enough to need a row
LimitRow limit_row(const Range& range, real x, real rate, real h);

/// A motor: a target speed, and the torque or force with which it can reach it.
struct Motor {
  real speed = 0;     ///< target rate of the coordinate [rad/s or m/s]
  real strength = 0;  ///< greatest torque or force in either direction [N m or N]; 0 is off
};

#ifndef JOINTS_LIBRARY  // exercises, which programs that link the library do not see
/// Exercise 3.5: the change of a motor's accumulated impulse by one solve.
/// \param rate J V, the rate of the coordinate now [rad/s or m/s]
/// \param K K of its row [1/(kg m^2) or 1/kg] \param h step [s]
/// \param sum its accumulated impulse in this step [N m s or N s], updated here
/// \return the change of the accumulated impulse [N m s or N s]
real motor_impulse(real rate, real K, const Motor& motor, real h, real& sum);
#endif

}  // namespace joints
/// @}
