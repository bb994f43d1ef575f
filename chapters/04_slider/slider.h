// Chapter 4: slider. Declares the functions that slider.cpp has to define. Read README.md in this
// folder first. Given: there is nothing to edit here.
#pragma once

#include "engine/block.h"

/// \defgroup chapter4 Chapter 4: slider
/// \brief Two rows that hold a line, three that hold an orientation, and the displacement along it.
/// @{
namespace joints {

/// Keeps a point of body 2 on a line that is fixed to body 1. Removes two degrees of freedom.
///
/// u = p2 - p1, n_i = R1 n_i_local perpendicular to the line; C = (u.n1, u.n2) [m];
/// row i of J: (-n_i, -(r1 + u) x n_i, n_i, r2 x n_i), exact at every pose;
/// K = J M^-1 J^T [1/kg]. Source: thesis, section 3.7.4.
struct Line {
  vec3 anchor1_local{0};     ///< a point of the line [m], body space of body 1
  vec3 anchor2_local{0};     ///< the point that stays on it [m], body space of body 2
  vec3 n1_local{0, 1, 0};    ///< unit, perpendicular to the line, body space of body 1
  vec3 n2_local{0, 0, 1};    ///< unit, perpendicular to the line and to n1, body space of body 1

  static constexpr int rows = 2;            ///< degrees of freedom that it removes
  static constexpr bool one_sided = false;  ///< both signs of impulse are allowed
  static constexpr Form form = Form::any;  ///< the form of its rows
  Vector<2> error(const Body& body1, const Body& body2) const;       ///< exercise 4.1 [m]
  Jacobian<2> jacobian(const Body& body1, const Body& body2) const;  ///< exercise 4.1
  Matrix<2> K(const Body& body1, const Body& body2) const;           ///< Eq. 4-5 [1/kg]
};

/// Keeps the orientation of body 2 relative to body 1. Removes three degrees of freedom.
///
/// q_e = q2 start^-1 q1^-1 = (s, e), negated if s < 0; C = 2 e [1], close to the vector of the
/// excess rotation [rad, world]; J = (0, -E, 0, E), which is exact where C = 0 and conserves
/// angular momentum everywhere; K = I1^-1 + I2^-1 [1/(kg m^2)]. At half a turn |C| is largest and
/// both directions back are equally long; the part takes one of the two.
/// Source: thesis, section 3.7.4, corrected: a rotation instead of differences of angles.
struct RotationLock {
  quat start{1, 0, 0, 0};  ///< q1^-1 q2 where the error is zero

  static constexpr int rows = 3;            ///< degrees of freedom that it removes
  static constexpr bool one_sided = false;  ///< both signs of impulse are allowed
  static constexpr Form form = Form::angular;  ///< the form of its rows
  vec3 error(const Body& body1, const Body& body2) const;            ///< exercise 4.2
  Jacobian<3> jacobian(const Body& body1, const Body& body2) const;  ///< exercise 4.2
  mat3 K(const Body& body1, const Body& body2) const;                ///< Eq. 4-9 [1/(kg m^2)]
};

/// Makes the lock that keeps the present relative orientation of the bodies.
RotationLock lock_of(const Body& body1, const Body& body2);

/// The displacement of body 2's point along the line. Limit and motor use its row.
///
/// a = R1 a1_local, u = p2 - p1; C = u.a [m]; J = (-a, -(r1 + u) x a, a, r2 x a), exact at every
/// pose; K = J M^-1 J^T [1/kg]. Source: thesis, section 3.7.4, corrected: the row of the motor
/// also has levers.
struct Slide {
  vec3 anchor1_local{0};    ///< where the displacement is zero [m], body space of body 1
  vec3 anchor2_local{0};    ///< the point that slides [m], body space of body 2
  vec3 a1_local{1, 0, 0};   ///< direction of the line, unit, body space of body 1

  static constexpr int rows = 1;            ///< one row, used by limit and motor
  static constexpr bool one_sided = false;  ///< false; the row of a limit is one-sided
  static constexpr Form form = Form::any;  ///< the form of its rows
  real error(const Body& body1, const Body& body2) const;    ///< exercise 4.3 [m]
  Row jacobian(const Body& body1, const Body& body2) const;  ///< exercise 4.3
  real K(const Body& body1, const Body& body2) const;        ///< Eq. 4-12 [1/kg]
};

}  // namespace joints
/// @}
