// Chapter 5: fixed joint. The functions of fixed.cpp. Read README.md beside it first.
// There is nothing to edit here.
#pragma once

#include "chapters/02_ball/ball.h"
#include "chapters/03_hinge/hinge.h"
#include "chapters/04_slider/slider.h"
#include "engine/parts/part.h"
#include "engine/kept/reaction.h"

/// \defgroup chapter5 Chapter 5: fixed joint
/// \brief Six rows in one block, the load that a joint transmits, and when it breaks.
/// @{
namespace joints {

#ifndef JOINTS_LIBRARY  // exercises, which programs that link the library do not see
/// Exercise 5.1: couples the point's three rows with the lock's three, X = J_t M^-1 J_r^T.
/// \return the upper right 3x3 block of a weld's K [1/(kg m)]
mat3 cross_K(const Point& point, const Body& body1, const Body& body2);
#endif

/// Holds two bodies rigidly together: a point (rows 1 to 3) and a lock (rows 4 to 6) in one block.
/// Removes six degrees of freedom.
///
/// C = (C of Point [m], C of RotationLock [1]); J likewise, exact where C = 0; K = J M^-1 J^T is
/// invertible if at least one body can move. Source: thesis, section 3.7.5, which solves the two
/// parts as two blocks.
using Weld = Composite<Point, RotationLock>;

#ifndef JOINTS_LIBRARY  // exercises, which programs that link the library do not see
/// The same K in closed form: ((K of Point, X), (X^T, K of RotationLock)), X = cross_K, Eq. 5-3.
Matrix<6> weld_K(const Weld& weld, const Body& body1, const Body& body2);
#endif

/// Exercise 5.2, first part: the mean load of a weld in a step.
/// \param impulse accumulated impulses of its six rows [N s, then N m s] \param h that step [s]
/// \return force on body 2, and torque on it about the anchor
Reaction carried(const Vector<6>& impulse, real h);

/// Exercise 5.2, second part: the same load with its torque about another point.
/// \param from the point of `load.torque` [m, world] \param to the new point [m, world]
Reaction about(const Reaction& load, const vec3& from, const vec3& to);

#ifndef JOINTS_LIBRARY  // exercises, which programs that link the library do not see
/// The load at which a weld breaks.
struct Strength {
  real force = unbounded;   ///< [N]
  real torque = unbounded;  ///< [N m], about the point that the load's torque is about
};

/// Exercise 5.2, third part: true if the force or the torque exceeds the strength.
bool breaks(const Reaction& load, const Strength& strength);

/// The parts for a joint of your own, all made for the same pose, anchor and axis; the axis is the
/// direction of the line, too.
struct Kit {
  Point point;        ///< of chapter 2, at the anchor
  Line line;          ///< of chapter 4, through the anchor
  Axis axis;          ///< of chapter 3
  RotationLock lock;  ///< of chapter 4
};
/// C, J and K of four rows that are solved as one block.
struct FourRows {
  Vector<4> C{};      ///< [the unit of each row]
  Jacobian<4> J;      ///< [that unit per m, or 1]
  Matrix<4> K{};      ///< J M^-1 J^T [1/kg, 1/(kg m) or 1/(kg m^2)]
};
/// Exercise 5.3, first part: a sleeve on a shaft, which slides along the kit's axis and rotates
/// about it, and moves in no other way. Removes four degrees of freedom; translations come first.
FourRows sleeve(const Kit& kit, const Body& body1, const Body& body2);

/// Exercise 5.3, second part: the mean load of four rows of any direction in a step.
/// \param impulse their accumulated impulses \param h that step [s]
/// \param seam the point of the torque [m, world] \return force and torque on body 2
Reaction transmitted(const Jacobian<4>& J, const Vector<4>& impulse, real h, const Body& body2,
                     const vec3& seam);
#endif

}  // namespace joints
/// @}
