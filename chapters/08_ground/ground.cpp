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
  todo("8.1");
  // end [exercise 8.1]
}

Row Corner::along(const vec3& direction, const Body& body1, const Body& body2) const {
  // begin [exercise 8.1]
  // Return the row {v1, w1, v2, w2} of Eq. 8-2. Both levers lead to the same point, point(...).
  todo("8.1");
  // end [exercise 8.1]
}

// ---- friction: bounds that follow the normal row --------------------------------------------

std::array<vec3, 2> tangents(const vec3& n, const vec3& sliding) {
  // begin [exercise 8.2]
  // Return {t1, t2} of Eq. 8-5: subtract from `sliding` its component along n and normalise the
  // rest. If the rest is shorter than 1e-4 m/s (a body at rest, or one that falls straight down:
  // rounding errors), begin with any vector that is not parallel to n instead.
  todo("8.2");
  // end [exercise 8.2]
}

real friction_impulse(real rate, real K, real mu, real normal, real& sum) {
  // begin [exercise 8.2]
  // Eq. 8-6 gives the accumulated impulse that would stop the sliding at once. It must stay within
  // +-mu normal. Store it in `sum` and return its change.
  todo("8.2");
  // end [exercise 8.2]
}

// ---- given ----------------------------------------------------------------------------------

real impact_speed(real C, real rate, real kick, real h) {
  // Leapfrog: velocities belong to times halfway between positions, so half of the kick is removed.
  const real now = rate - kick / 2;
  return std::sqrt(std::max(real(0), now * now - 2 * kick / h * C));  // Eq. 8-9
}

}  // namespace joints
