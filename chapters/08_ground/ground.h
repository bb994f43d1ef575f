// Chapter 8: the ground. The functions of ground.cpp. Read README.md beside it first.
// There is nothing to edit here.
#pragma once

#include <array>
#include <vector>

#include "chapters/03_hinge/hinge.h"

/// \defgroup chapter8 Chapter 8: ground
/// \brief A row that only pushes, two rows bounded by its impulse, and bodies that rest and roll.
/// @{
namespace joints {

/// A corner of body 2 above the top of body 1, or the lowest point of a ball of body 2. "Up" is the
/// y axis of body 1. Removes one degree of freedom while it touches, none otherwise.
///
/// n = R1 e_y; p = x2 + R2 corner_local - radius n, r1 = p - x1, r2 = p - x2;
/// C = n.r1 - height >= 0, the gap [m]; J = (-n, -(r1 x n), n, r2 x n), exact at every pose: n is
/// fixed in body 1, and its rotation is in the term of r1; K = J M^-1 J^T [1/kg].
/// Source: thesis, section 3.2; Catto 2006 for the contact as a row that only pushes.
struct Corner {
  vec3 corner_local{0};  ///< the corner, or the ball's centre [m], body space of body 2
  real radius = 0;       ///< of a ball about it [m]; 0 for a sharp corner
  real height = 0;       ///< of the top above the centre of body 1 [m]

  static constexpr int rows = 1;           ///< at most, while the corner touches
  static constexpr bool one_sided = true;  ///< it only pushes
  static constexpr Form form = Form::any;  ///< the form of its rows
  /// n, the direction in which the top faces: unit, world.
  static vec3 up(const Body& body1) { return to_world(body1, vec3(0, 1, 0)); }
  /// p, the point of body 2 that touches first [m, world].
  vec3 point(const Body& body1, const Body& body2) const {
    const vec3 centre = world_point(body2, corner_local);
    return radius == 0 ? centre : centre - radius * up(body1);
  }
  real error(const Body& body1, const Body& body2) const;  ///< exercise 8.1: C, the gap [m]
  /// The row of C: the one along n.
  Row jacobian(const Body& body1, const Body& body2) const {
    return along(up(body1), body1, body2);
  }
  /// J M^-1 J^T by chapter 3's coupling() [1/kg].
  real K(const Body& body1, const Body& body2) const {
    const Row J = jacobian(body1, body2);
    return coupling(J, J, body1, body2);
  }
  /// Exercise 8.1: the row whose J V is the velocity of the point of body 2 relative to body 1, as
  /// if body 1 extended up to it, along `direction` [m/s]. \param direction unit, world
  Row along(const vec3& direction, const Body& body1, const Body& body2) const;
};

/// Exercise 8.2: the two directions of friction.
/// \param n unit \param sliding the velocity of the point over the ground [m/s], of any direction
/// \return t1, t2: unit, perpendicular to n and to each other; t1 is the direction of sliding,
/// t2 = n x t1. At rest (below 1e-4 m/s perpendicular to n) t1 is any such direction.
std::array<vec3, 2> tangents(const vec3& n, const vec3& sliding);

#ifndef JOINTS_LIBRARY  // exercises, which programs that link the library do not see
/// Exercise 8.2: the change of a friction row's impulse by one solve.
/// \param rate J V, the speed along its direction [m/s] \param K of its row [1/kg], positive
/// \param mu coefficient of friction [1]
/// \param normal the accumulated impulse of the normal row in this step [N s]
/// \param sum the accumulated impulse of this row in this step [N s], updated here
/// \return the change of the accumulated impulse [N s]
real friction_impulse(real rate, real K, real mu, real normal, real& sum);

/// The three rows of a corner, in the order in which they are solved: t1, t2, n.
struct ContactRows {
  std::array<Row, 3> J{};     ///< the rows
  std::array<real, 3> K{};    ///< of each [1/kg], positive
  real bias = 0;              ///< b of the normal row [m/s]
  std::array<real, 3> sum{};  ///< accumulated impulses [N s]
};

/// Exercise 8.3: the corners that get rows in this step, at most four, Eq. 8-4.
/// \param C gap of each corner of a body [m] \param rate its v_n [m/s] \param h step [s]
/// \param margin of Eq. 8-4, 0.1 m/s \return indices into `C`, in any order
std::vector<int> live_corners(const std::vector<real>& C, const std::vector<real>& rate, real h,
                              real margin);

/// Exercise 8.3: one iteration over all corners. Changes the sums and the bodies' velocities.
/// \param mu coefficient of friction [1]
void solve_contact(std::vector<ContactRows>& corners, real mu, Body& body1, Body& body2);

/// What a corner does after an impact.
struct Bounce {
  real speed = 0;  ///< the J V that the rebound requires [m/s]; 0: the corner does not rebound
  real ratio = 0;  ///< greatest impulse of the rebound over the one that stopped the corner [1]
};

/// Exercise 8.4: the second solve after the move. Friction is left out.
/// \param corners their sums are those that stopped them \param bounces one for each corner
void rebound(std::vector<ContactRows>& corners, const std::vector<Bounce>& bounces, int iterations,
             Body& body1, Body& body2);
#endif

/// Exercise 8.4: the speed of a corner when it reaches the ground at the constant acceleration
/// kick / h. \param C gap [m] \param rate J V with the forces of this step [m/s], negative
/// \param kick the part of it that they added [m/s] \param h step [s]
/// \return positive [m/s]; 0 where no such speed exists
real impact_speed(real C, real rate, real kick, real h);

}  // namespace joints
/// @}
