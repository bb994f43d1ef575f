// Chapter 6: Baumgarte. The functions of baumgarte.cpp. Read README.md beside it first.
// There is nothing to edit here.
#pragma once

#include <numbers>

#include "chapters/01_distance/rods.h"
#include "chapters/02_ball/ball.h"

/// \defgroup chapter6 Chapter 6: Baumgarte
/// \brief Error fed back as a velocity, the warm start, position projection, and the soft step.
/// @{
namespace joints {

/// Exercise 6.1, first part: the bias of an equality.
/// \param C its error [m or rad] \param beta fraction of it removed per step [1]
/// \param h the step [s] \return b of J V + b = 0 [m/s or rad/s]
real bias(real C, real beta, real h);

/// Exercise 6.1, second part: the bias of a row that may only push C up, such as a limit or a rope.
/// \param C gap or slack if positive; violation if negative [m or rad]
/// \return b [m/s or rad/s]: J V = -b is the fastest approach allowed, or the rate of correction
real limit_bias(real C, real beta, real h);

/// Exercise 6.1, third part: the beta that halves an error in a given time.
/// \param half_time [s], positive \param h the step [s] \return beta [1], between 0 and 1
real beta_for(real half_time, real h);

/// Exercise 6.2, first part: warm-starts a joint with its impulses of the last step.
/// \param J its rows at the present poses
/// \param ratio length of this step over that of the last, h/h_before > 0 [1]
/// \param lambda in: the accumulated impulses of the last step; out: the initial impulses of this
/// step, which this function applies to the two bodies [N s]
void warm_start(const Jacobian<3>& J, real ratio, vec3& lambda, Body& body1, Body& body2);

/// Exercise 6.2, second part: true if a warm start together with beta keeps a chain stable
/// (Eq. 6-9; a hub with three or more joints may be unstable all the same).
/// \param rho factor by which an iteration multiplies the velocity error, after many [1], 0 to 1
/// \param iterations per step \param beta fraction of the error fed back per step [1]
bool warm_start_is_safe(real rho, int iterations, real beta);

/// Exercise 6.3, first part: position projection of one joint. Moves and rotates the two bodies so
/// that the gap of the point is zero to first order; their velocities do not change. At least one
/// of the two must be movable: between two static bodies K is zero and has no inverse.
void project(const Point& point, Body& body1, Body& body2);

/// Exercise 6.3, second part: the same for a rope; a slack rope moves no body. At least one of the
/// two bodies must be movable.
void project(const Rope<Distance>& rope, Body& body1, Body& body2);

/// Bodies in a row; joint k connects body k to body k + 1.
struct Chain {
  std::vector<Body> bodies;   ///< the first one is static
  std::vector<Point> joints;  ///< one less than bodies
};

/// Exercise 6.3, third part: one iteration of position projection projects every joint of the chain
/// once, in order, each at the poses that result from the previous one.
void projection_iteration(Chain& chain);

#ifndef JOINTS_LIBRARY  // exercises, which programs that link the library do not see
/// A joint of a chain, prepared for iterations at the present poses.
struct JointRows {
  Jacobian<3> J;  ///< its rows
  mat3 K;         ///< J M^-1 J^T [1/kg]
  vec3 C;         ///< its gap [m, world]
};
/// The rows of all joints of a chain; those of joint k act on body k and body k + 1.
inline std::vector<JointRows> rows_of(const Chain& chain) {
  std::vector<JointRows> out;
  for (std::size_t k = 0; k < chain.joints.size(); ++k) {
    const Body &body1 = chain.bodies[k], &body2 = chain.bodies[k + 1];
    const Point& joint = chain.joints[k];
    out.push_back({joint.jacobian(body1, body2), joint.K(body1, body2), joint.error(body1, body2)});
  }
  return out;
}
/// The bodies of a chain move with their velocities. \param h the step [s]
inline void move(Chain& chain, real h) {
  for (Body& body : chain.bodies) {
    if (body.is_static()) continue;
    body.x += h * body.v;
    body.q = turned(body.q, body.w, h);
  }
}

/// A block with the properties of a spring and a damper: J V + rate C + softness K lambda = 0.
struct SoftRow {
  real rate = 0;      ///< factor of C in the bias [1/s]
  real softness = 0;  ///< the fraction of K by which it yields to its impulse [1]; 0: a hard row
};
/// Exercise 6.4, first part: Eq. 6-15. Source: Catto, "Soft Constraints", GDC 2011.
/// \param frequency of the spring with the bodies, undamped [Hz], positive
/// \param damping its damping ratio [1], not negative \param h the step or substep [s]
SoftRow soft_row(real frequency, real damping, real h);

/// Exercise 6.4, second part: one iteration of a soft block.
/// \param rows the block \param soft rate and softness of all of its rows
/// \param lambda in and out: the accumulated impulse, which acts on the bodies already [N s]
void soft_iteration(const JointRows& rows, const SoftRow& soft, vec3& lambda, Body& body1,
                    Body& body2);

/// The settings of a soft step.
struct SoftStep {
  real frequency = 60;  ///< of all joints [Hz]
  real damping = 2;     ///< damping ratio of all joints [1]
  int substeps = 4;     ///< parts of a step, with one iteration each; at least 1
  int relax = 1;        ///< iterations without bias after the bodies have moved, per substep
};
/// Exercise 6.4, third part: a step of a chain in substeps with a warm start, one soft iteration
/// and `relax` hard ones each (Eq. 6-16 and 6-17).
/// \param impulses one per joint; in: of the last substep before; out: of the last one [N s]
/// \param gravity [m/s^2] \param h the whole step [s], as long as the last one
void soft_step(Chain& chain, std::vector<vec3>& impulses, const SoftStep& how, const vec3& gravity,
               real h);
#endif

}  // namespace joints
/// @}
