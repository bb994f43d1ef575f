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
  todo("8.1");
  // end [exercise 8.1]
}

Row Corner::along(const vec3& direction, const Body& body1, const Body& body2) const {
  // begin [exercise 8.1]
  // Return the row {v1, w1, v2, w2} of Eq. 8-2. Both levers reach to the same point, the one of
  // body 2 that touches.
  todo("8.1");
  // end [exercise 8.1]
}

// ---- the bound that moves -------------------------------------------------------------------

std::array<vec3, 2> tangents(const vec3& n, const vec3& sliding) {
  // begin [exercise 8.2]
  // Return {t1, t2}, Eq. 8-5: take from `sliding` what is along n, and make the rest a unit vector.
  // Where less than 1e-4 m/s is left (a body at rest, or one that falls straight down: rounding),
  // begin with any vector that is not along n instead.
  todo("8.2");
  // end [exercise 8.2]
}

real friction_impulse(real rate, real K, real mu, real normal, real& sum) {
  // begin [exercise 8.2]
  // The impulse that stops the sliding at once would make the sum `wanted`, Eq. 8-6. The sum may
  // not leave +-mu normal. Store the new sum, return how much it changed.
  todo("8.2");
  // end [exercise 8.2]
}

// ---- given ----------------------------------------------------------------------------------

real impact_speed(real C, real rate, real kick, real h) {
  const real now = rate - kick / 2;  // with this a true fall over the step's way begins
  return std::sqrt(std::max(real(0), now * now - 2 * kick / h * C));  // Eq. 8-9
}

}  // namespace joints
