// Chapter 2: a block of three rows. Declares the functions that ball.cpp has to define. Read
// README.md in this folder first. Given: there is nothing to edit here.
#pragma once

#include <algorithm>
#include <array>

#include "engine/matrix.h"

/// \defgroup chapter2 Chapter 2: ball
/// \brief Three rows solved together, and the rotation of a body in a step.
/// @{
namespace joints {

/// Holds a point of body 1 and a point of body 2 together. Removes three degrees of freedom.
///
/// u = p2 - p1 = x2 + r2 - x1 - r1, C = u [m]; J = (-E, skew(r1), E, -skew(r2)), exact at every
/// pose; K [1/kg], Eq. 2-6, is never singular while one body can move. Source: thesis, section
/// 3.7.2.
struct Point {
  vec3 anchor1_local{0};  ///< the point on body 1 [m], from its centre, body space
  vec3 anchor2_local{0};  ///< the point on body 2 [m], from its centre, body space

  static constexpr int rows = 3;            ///< degrees of freedom that it removes
  static constexpr bool one_sided = false;  ///< it pushes and it pulls
  static constexpr Form form = Form::point;  ///< the form of its rows
  /// C, the gap [m, world]: the vector from the point on body 1 to the point on body 2.
  vec3 error(const Body& body1, const Body& body2) const {
    return world_point(body2, anchor2_local) - world_point(body1, anchor1_local);  // Eq. 2-1
  }
  Jacobian<3> jacobian(const Body& body1, const Body& body2) const;  ///< exercise 2.1
  mat3 K(const Body& body1, const Body& body2) const;                ///< exercise 2.2 [1/kg]
};

/// Validates it. \throws std::invalid_argument unless both anchors are finite
inline void check(const Point& point) {
  if (finite(sum(point.anchor1_local) + sum(point.anchor2_local))) return;
  require_finite("anchor1_local", point.anchor1_local, "must be finite [m]");
  require_finite("anchor2_local", point.anchor2_local, "must be finite [m]");
}
/// Makes the part that holds two bodies together at the world point `anchor` [m], from their
/// present poses.
inline Point point_at(const Body& body1, const Body& body2, const vec3& anchor) {
  return {to_local(body1, anchor - body1.x), to_local(body2, anchor - body2.x)};
}

#ifndef JOINTS_LIBRARY  // exercises, which programs that link the library do not see
/// Exercise 2.3, first half: the impulse that satisfies three rows at the same time.
/// \param K J M^-1 J^T of the block [1/kg], not singular
/// \param bias minus the required J V [m/s]
/// \return lambda [N s] such that J V + bias = 0 after apply_impulse
vec3 block_impulse(const Jacobian<3>& J, const mat3& K, const vec3& bias, const Body& body1,
                   const Body& body2);

/// Exercise 2.3, second half: V += M^-1 J^T lambda for all three rows. \param lambda [N s]
void apply_impulse(const Jacobian<3>& J, const vec3& lambda, Body& body1, Body& body2);

/// Exercise 2.4: the orientation after h seconds at a constant angular velocity.
/// \param q orientation now, unit length \param w angular velocity [rad/s, world] \param h > 0 [s]
/// \return the new orientation, unit length
quat turned(const quat& q, const vec3& w, real h);

/// The body's own axes in the order of their moments, the largest first; 0 is x, 1 is y, 2 is z.
inline std::array<int, 3> axes_by_moment(const Body& body) {
  std::array<int, 3> axes{0, 1, 2};
  const vec3& inverse = body.inverse_inertia_local;
  std::sort(axes.begin(), axes.end(), [&](int i, int j) { return inverse[i] < inverse[j]; });
  return axes;
}

/// Exercise 2.5: the free rotation of a body for h seconds by Eq. 2-11. Changes its q and w; its
/// angular momentum in the world stays. rotate_freely() of the engine does it in smaller parts.
/// \param body movable \param h time, also negative [s]
void tumble(Body& body, real h);
#endif

}  // namespace joints
/// @}
