// Moves a kinematic body to a place.
#pragma once

#include "engine/body.h"

/// \addtogroup bodies
/// @{
namespace joints {

/// Sets v and w of a kinematic body such that it is at x and q after h seconds. It keeps these
/// velocities until the program sets others. Of the two rotations that lead to q, it takes the
/// shorter one. \param x its centre then [m] \param q its orientation then (normalised here)
/// \param h time until then [s], the length of a whole step, whatever its substeps
/// \throws std::invalid_argument unless the body is kinematic, all is finite and h positive
inline void move_to(Body& body, const vec3& x, const quat& q, real h) {
  require(body.kinematic, "body: only a kinematic body can be moved to a place");
  require(h > 0 && h < unbounded, "h", h, "must be positive and finite [s]");
  const Body there = static_body(x, q);  // validates both
  quat e = there.q * conjugate(body.q);
  if (e.w < 0) e = -e;
  const vec3 axis(e.x, e.y, e.z);
  const real sine = length(axis), angle = 2 * std::atan2(sine, e.w);
  body.v = (there.x - body.x) / h;
  body.w = (sine > 0 ? angle / sine : real(2)) / h * axis;
}

}  // namespace joints
/// @}
