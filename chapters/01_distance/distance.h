// Chapter 1: one row. What distance.cpp has to provide. Read the text first: README.md beside it.
// There is nothing to edit here.
#pragma once

#include <vector>

#include "engine/matrix.h"
#include "engine/todo.h"

/// \defgroup chapter1 Chapter 1: distance
/// \brief One row: rod, rope, the impulse of a row and the step of a whole simulation.
/// @{
namespace joints {

/// The unit vector along u, or the zero vector if u is zero: a row made of it does nothing.
inline vec3 direction(const vec3& u) {
  const real size = length(u);
  return size > 0 ? u / size : vec3(0);
}

/// A rod of fixed length between the centres of two bodies. Removes one degree of freedom.
///
/// C = |x2 - x1| - length [m]; J = (-n, 0, n, 0), n = (x2 - x1)/|x2 - x1|, exact wherever the
/// centres differ; K = 1/m1 + 1/m2 [1/kg]. Centres that coincide: J = 0, no impulse.
/// Source: thesis, section 3.7.1, with its effective mass corrected (erratum E19).
struct CentreDistance {
  real length = 1;  ///< of the rod [m]

  static constexpr int rows = 1;            ///< degrees of freedom that it removes
  static constexpr bool one_sided = false;  ///< it pushes and it pulls
  /// C, the error [m]: positive when the rod is too long.
  real error(const Body& body1, const Body& body2) const {
    return glm::length(body2.x - body1.x) - length;  // Eq. 1-1
  }
  Row jacobian(const Body& body1, const Body& body2) const;  ///< exercise 1.1
  real K(const Body& body1, const Body& body2) const;        ///< exercise 1.2 [1/kg]
};

/// A rod between any point of one body and any point of another. Removes one degree of freedom.
///
/// u = p2 - p1, n = u/|u|, C = |u| - length [m]; J = (-n, -(r1 x n), n, r2 x n), exact wherever
/// |u| > 0; K = 1/m1 + 1/m2 + (r1 x n).I1^-1 (r1 x n) + (r2 x n).I2^-1 (r2 x n) [1/kg].
/// Points that coincide: J = 0, no impulse. Source: the centre rod with the velocity v + w x r of a
/// point; Garstenauer 2006 has it for joints in general.
struct Distance {
  vec3 anchor1_local{0};  ///< its end on body 1 [m], from the centre, body space
  vec3 anchor2_local{0};  ///< its end on body 2 [m], from the centre, body space
  real length = 1;        ///< of the rod [m]

  static constexpr int rows = 1;            ///< degrees of freedom that it removes
  static constexpr bool one_sided = false;  ///< it pushes and it pulls
  /// C, the error [m]: positive when the rod is too long.
  real error(const Body& body1, const Body& body2) const {
    const vec3 u = world_point(body2, anchor2_local) - world_point(body1, anchor1_local);
    return glm::length(u) - length;  // Eq. 1-13
  }
  Row jacobian(const Body& body1, const Body& body2) const;  ///< exercise 1.6
  real K(const Body& body1, const Body& body2) const;        ///< exercise 1.6 [1/kg]
};

/// A rope: a rod that cannot push. C >= 0 is the slack: the negative of the rod's C.
///
/// C = length - |u| [m], the negative of Eq. 1-13; J is minus the rod's (Eq. 1-15), K the rod's
/// (Eq. 1-16); bias C/h while there is slack, beta C/h otherwise (Eq. 1-11; set_up does it); its
/// accumulated impulse must not become negative
/// (exercise 1.5). Removes one degree of freedom while taut.
template <class Rod>
struct Rope {
  Rod rod;  ///< the rod that it is when taut

  static constexpr int rows = 1;           ///< at most, while it is taut
  static constexpr bool one_sided = true;  ///< it only pulls
  /// C, the slack [m]: negative when the rope is overstretched.
  real error(const Body& body1, const Body& body2) const { return -rod.error(body1, body2); }
  /// Minus the rod's row.
  Row jacobian(const Body& body1, const Body& body2) const {
    const Row J = rod.jacobian(body1, body2);
    return {-J.v1, -J.w1, -J.v2, -J.w2};
  }
  /// The rod's K: both signs cancel [1/kg].
  real K(const Body& body1, const Body& body2) const { return rod.K(body1, body2); }
};

/// Exercise 1.3, first half: the impulse that makes the row true.
/// \param J the row \param K its J M^-1 J^T [1/kg], not negative
/// \param bias minus the wanted J V [m/s]
/// \return lambda [N s] such that J V + bias = 0 after apply_impulse; 0 where K is 0
real row_impulse(const Row& J, real K, real bias, const Body& body1, const Body& body2);

/// Exercise 1.3, second half: V += M^-1 J^T lambda. \param lambda [N s]
void apply_impulse(const Row& J, real lambda, Body& body1, Body& body2);

/// Exercise 1.5: how much of `dlambda` a rope may apply.
/// \param dlambda the impulse that would make its row true in this iteration [N s]
/// \param sum the accumulated impulse of the rope in this step [N s], updated here
/// \return the change of the accumulated impulse, which must not become negative [N s]
real clamp_sum(real dlambda, real& sum);

/// A rod or a rope between the centres of two bodies of an array.
struct Link {
  int body1 = 0, body2 = 1;  ///< indices into the array
  real length = 1;           ///< [m]
  bool rope = false;         ///< only pulls
};

/// The row of a link in one step.
struct LinkRow {
  Row J;          ///< the row
  real K = 0;     ///< J M^-1 J^T [1/kg]
  real bias = 0;  ///< minus the wanted J V [m/s]
  real sum = 0;   ///< accumulated impulse [N s]
};

/// Settings of step().
struct StepSettings {
  vec3 gravity{0, real(-9.81), 0};  ///< [m/s^2]
  real h = real(1) / 60;            ///< length of a step [s]
  int iterations = 30;              ///< iterations over all links
  real beta = real(0.2);            ///< share of the error fed back in a step [1] (chapter 6)
};

/// Given: the row of a link at the bodies' present positions.
LinkRow set_up(const Link& link, const std::vector<Body>& bodies, const StepSettings& settings);

/// Exercise 1.4: one step of the whole simulation, Algorithm 1 of the thesis.
/// Forces, rows, iterations, positions. Orientations do not change: nothing here rotates a body.
void step(std::vector<Body>& bodies, const std::vector<Link>& links,
          const StepSettings& settings);

}  // namespace joints
/// @}
