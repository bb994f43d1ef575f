// Chapter 1: rod, rope and the impulse of one row. Declares functions that distance.cpp has to
// define; distance.h declares the others. Given: there is nothing to edit here.
#pragma once

#include "engine/matrix.h"

/// \defgroup chapter1 Chapter 1: distance
/// \brief One row: rod, rope, the impulse of a row and the step of a whole simulation.
/// @{
namespace joints {

/// The unit vector along u, or the zero vector if u is zero; a row made from that has no effect.
inline vec3 direction(const vec3& u) {
  const real size = length(u);
  return size > 0 ? u / size : vec3(0);
}

/// A rod of fixed length between the centres of two bodies. Removes one degree of freedom.
///
/// C = |x2 - x1| - length [m]; J of Eq. 1-4 is exact wherever the centres differ, where they
/// coincide it is 0, and so is the impulse; K [1/kg] is Eq. 1-7. Source: thesis, section 3.7.1,
/// with its effective mass corrected (erratum E19).
struct CentreDistance {
  real length = 1;  ///< length of the rod [m]

  static constexpr int rows = 1;            ///< degrees of freedom that it removes
  static constexpr bool one_sided = false;  ///< it pushes and it pulls
  static constexpr Form form = Form::any;  ///< the form of its rows
  /// C, the error [m]: positive when the rod is too long.
  real error(const Body& body1, const Body& body2) const {
    return glm::length(body2.x - body1.x) - length;  // Eq. 1-1
  }
  Row jacobian(const Body& body1, const Body& body2) const;  ///< exercise 1.1
  real K(const Body& body1, const Body& body2) const;        ///< exercise 1.2 [1/kg]
};

/// A rod of fixed length from a point of body 1 to a point of body 2. Removes one degree of
/// freedom.
///
/// u = p2 - p1, C = |u| - length [m]; J of Eq. 1-15 is exact wherever |u| > 0, where the points
/// coincide it is 0, and so is the impulse; K [1/kg] is Eq. 1-16. Source: the centre rod, with the
/// velocity v + w x r of a point instead of that of a centre; Garstenauer 2006 treats joints in
/// general so.
struct Distance {
  vec3 anchor1_local{0};  ///< the end on body 1 [m], from the centre, body space
  vec3 anchor2_local{0};  ///< the end on body 2 [m], from the centre, body space
  real length = 1;        ///< length of the rod [m]

  static constexpr int rows = 1;            ///< degrees of freedom that it removes
  static constexpr bool one_sided = false;  ///< it pushes and it pulls
  static constexpr Form form = Form::any;  ///< the form of its rows
  /// C, the error [m]: positive when the rod is too long.
  real error(const Body& body1, const Body& body2) const {
    const vec3 u = world_point(body2, anchor2_local) - world_point(body1, anchor1_local);
    return glm::length(u) - length;  // Eq. 1-13
  }
  Row jacobian(const Body& body1, const Body& body2) const;  ///< exercise 1.6
  real K(const Body& body1, const Body& body2) const;        ///< exercise 1.6 [1/kg]
};

/// A rope: a rod that cannot push. C >= 0 is the slack, the negative of the rod's C.
///
/// C = length - |u| [m], the negative of Eq. 1-13; J is minus the rod's J (Eq. 1-15), and K is the
/// rod's K (Eq. 1-16). The bias is C/h while there is slack and beta C/h otherwise (Eq. 1-11, in
/// set_up). The accumulated impulse must not become negative (exercise 1.5). Removes one degree of
/// freedom while the rope is taut.
template <class Rod>
struct Rope {
  Rod rod;  ///< the rod to which a taut rope is equivalent

  static constexpr int rows = 1;           ///< degrees of freedom that it removes while taut
  static constexpr bool one_sided = true;  ///< it only pulls
  static constexpr Form form = Form::any;  ///< the form of its rows
  /// C, the slack [m]: negative when the rope is overstretched.
  real error(const Body& body1, const Body& body2) const { return -rod.error(body1, body2); }
  /// Minus the rod's row.
  Row jacobian(const Body& body1, const Body& body2) const {
    const Row J = rod.jacobian(body1, body2);
    return {-J.v1, -J.w1, -J.v2, -J.w2};
  }
  /// The rod's K [1/kg]: the minus sign appears twice and cancels.
  real K(const Body& body1, const Body& body2) const { return rod.K(body1, body2); }
};

#ifndef JOINTS_LIBRARY  // exercises, which programs that link the library do not see
/// Exercise 1.3, first half: the impulse that satisfies the row.
/// \param J the row \param K J M^-1 J^T of the row [1/kg], not negative
/// \param bias minus the required J V [m/s]
/// \return lambda [N s] such that J V + bias = 0 after apply_impulse; 0 where K is 0
real row_impulse(const Row& J, real K, real bias, const Body& body1, const Body& body2);

/// Exercise 1.3, second half: V += M^-1 J^T lambda. \param lambda [N s]
void apply_impulse(const Row& J, real lambda, Body& body1, Body& body2);

/// Exercise 1.5: the part of `dlambda` that a rope may apply.
/// \param dlambda the impulse that would satisfy its row in this iteration [N s]
/// \param sum the accumulated impulse of the rope in this step [N s], updated here; it must not
/// become negative
/// \return the change of the accumulated impulse [N s]
real clamp_sum(real dlambda, real& sum);
#endif

}  // namespace joints
/// @}
