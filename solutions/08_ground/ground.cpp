// Chapter 8: the ground. Read README.md beside this file; the exercises are in the order of the
// text. What each function promises stands in ground.h.
#include "chapters/08_ground/ground.h"

#include <algorithm>
#include <cmath>

namespace joints {

// ---- a row that only pushes -----------------------------------------------------------------

real Corner::error(const Body& body1, const Body& body2) const {
  // begin [exercise 8.1]
  // Return C, Eq. 8-1: how far the point of body 2 is above the top of body 1, along n.
  // point(body1, body2) and up(body1) are given in ground.h.
  return dot(up(body1), point(body1, body2) - body1.x) - height;  // Eq. 8-1
  // end [exercise 8.1]
}

Row Corner::along(const vec3& direction, const Body& body1, const Body& body2) const {
  // begin [exercise 8.1]
  // Return the row {v1, w1, v2, w2} of Eq. 8-2. Both levers reach to the same point, the one of
  // body 2 that touches.
  const vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x;
  return {-direction, -cross(r1, direction), direction, cross(r2, direction)};  // Eq. 8-2
  // end [exercise 8.1]
}

// ---- the bound that moves -------------------------------------------------------------------

std::array<vec3, 2> tangents(const vec3& n, const vec3& sliding) {
  // begin [exercise 8.2]
  // Return {t1, t2}, Eq. 8-5: take from `sliding` what is along n, and make the rest a unit vector.
  // Where less than 1e-4 m/s is left (a body at rest, or one that falls straight down: rounding),
  // begin with any vector that is not along n instead.
  vec3 across = sliding - dot(n, sliding) * n;
  if (length(across) < real(1e-4)) {
    const vec3 other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0);
    across = other - dot(n, other) * n;
  }
  const vec3 t1 = normalize(across);
  return {t1, cross(n, t1)};  // Eq. 8-5
  // end [exercise 8.2]
}

real friction_impulse(real rate, real K, real mu, real normal, real& sum) {
  // begin [exercise 8.2]
  // The impulse that stops the sliding at once would make the sum `wanted`, Eq. 8-6. The sum may
  // not leave +-mu normal. Store the new sum, return how much it changed.
  const real wanted = sum - rate / K, bound = mu * normal;
  const real before = sum;
  sum = std::clamp(wanted, -bound, bound);  // Eq. 8-6
  return sum - before;
  // end [exercise 8.2]
}

// ---- given ----------------------------------------------------------------------------------

real impact_speed(real C, real rate, real kick, real h) {
  const real now = rate - kick / 2;  // with this a true fall over the step's way begins
  return std::sqrt(std::max(real(0), now * now - 2 * kick / h * C));  // Eq. 8-9
}

}  // namespace joints
