// Chapter 6: Baumgarte. What baumgarte.cpp has to provide. Read README.md beside it first.
// There is nothing to edit here.
#pragma once

#include "chapters/01_distance/distance.h"
#include "chapters/02_ball/ball.h"

/// \defgroup chapter6 Chapter 6: Baumgarte
/// \brief Error fed back as a velocity, the warm start, and position projection.
/// @{
namespace joints {

/// Exercise 6.1, first part: the bias of an equality.
/// \param C its error [m or rad] \param beta share of it that a step shall take away [1]
/// \param h the step [s] \return b of J V + b = 0 [m/s or rad/s]
real bias(real C, real beta, real h);

/// Exercise 6.1, second part: the bias of a row that may only push C up, such as a limit or a rope.
/// \param C what it has left [m or rad]: room if positive, too far if negative \return b [m/s or
/// rad/s]: with it J V + b = 0 is the fastest approach that is allowed, or the way back
real limit_bias(real C, real beta, real h);

/// Exercise 6.1, third part: the beta with which half of an error is gone after a time.
/// \param half_time [s], positive \param h the step [s] \return beta [1], between 0 and 1
real beta_for(real half_time, real h);

/// Exercise 6.2, first part: a joint begins the step with what it gave in the last one.
/// \param J its rows at the present poses \param ratio this step over the last one, h/h_before [1]
/// \param lambda in: its impulses of the last step; out: those that it begins this one with, which
/// have been applied to the two bodies [N s]
void warm_start(const Jacobian<3>& J, real ratio, vec3& lambda, Body& body1, Body& body2);

/// Exercise 6.2, second part: does a warm start together with beta keep a scene stable?
/// \param rho what an iteration leaves of the error in the long run [1], from 0 to 1
/// \param iterations in a step \param beta share of the error fed back in a step [1]
bool warm_start_is_safe(real rho, int iterations, real beta);

/// Exercise 6.3, first part: a visit of position projection. Moves and turns the two bodies so that
/// the gap of the point is zero to first order; their velocities stay as they are. At least one of
/// the two can move: between two static bodies K is zero and has no inverse.
void project(const Point& point, Body& body1, Body& body2);

/// Exercise 6.3, second part: the same for a rope, which is left alone while it is slack. At least
/// one of the two bodies can move.
void project(const Rope<Distance>& rope, Body& body1, Body& body2);

/// Bodies in a row; joint k holds body k to body k + 1.
struct Chain {
  std::vector<Body> bodies;   ///< the first one is static
  std::vector<Point> joints;  ///< one less than bodies
};

/// Exercise 6.3, third part: an iteration of position projection visits every joint of the chain
/// once, in their order, each at the poses that the one before it has left.
void projection_iteration(Chain& chain);

}  // namespace joints
/// @}
