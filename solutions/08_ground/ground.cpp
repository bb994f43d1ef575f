// Chapter 8: the ground. Replace each todo(...) by your own code; the text is in README.md.
#include "chapters/08_ground/ground.h"

#include <algorithm>
#include <cmath>

namespace joints {

// ---- a row that only pushes -----------------------------------------------------------------

real Corner::error(const Body& body1, const Body& body2) const {
  // begin [exercise 8.1]
  // Return C of Eq. 8-1: the height of body 2's point above the top of body 1, along n.
  // point(body1, body2) and up(body1) are given in ground.h.
  return dot(up(body1), point(body1, body2) - body1.x) - height;  // Eq. 8-1
  // end [exercise 8.1]
}

Row Corner::along(const vec3& direction, const Body& body1, const Body& body2) const {
  // begin [exercise 8.1]
  // Return the row {v1, w1, v2, w2} of Eq. 8-2. Both levers lead to the same point, point(...).
  const vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x;
  return {-direction, -cross(r1, direction), direction, cross(r2, direction)};  // Eq. 8-2
  // end [exercise 8.1]
}

// ---- friction: bounds that follow the normal row --------------------------------------------

std::array<vec3, 2> tangents(const vec3& n, const vec3& sliding) {
  // begin [exercise 8.2]
  // Return {t1, t2} of Eq. 8-5: subtract from `sliding` its component along n and normalise the
  // rest. If the rest is shorter than 1e-4 m/s (a body at rest, or one that falls straight down:
  // rounding errors), begin with any vector that is not parallel to n instead.
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
  // Eq. 8-6 gives the accumulated impulse that would stop the sliding at once. It must stay within
  // +-mu normal. Store it in `sum` and return its change.
  const real wanted = sum - rate / K, bound = mu * normal;
  const real before = sum;
  sum = std::clamp(wanted, -bound, bound);  // Eq. 8-6
  return sum - before;
  // end [exercise 8.2]
}

// ---- given ----------------------------------------------------------------------------------

real impact_speed(real C, real rate, real kick, real h) {
  // Leapfrog: velocities belong to times halfway between positions, so half of the kick is removed.
  const real now = rate - kick / 2;
  return std::sqrt(std::max(real(0), now * now - 2 * kick / h * C));  // Eq. 8-9
}

}  // namespace joints
