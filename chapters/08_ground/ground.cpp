// Chapter 8: the ground. Replace each todo(...) by your own code; the text is in README.md.
#include "chapters/08_ground/ground.h"

#include <algorithm>
#include <cmath>

#include "chapters/01_distance/rods.h"
#include "engine/instruments/todo.h"

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

// ---- all corners of a body ------------------------------------------------------------------

std::vector<int> live_corners(const std::vector<real>& C, const std::vector<real>& rate, real h,
                              real margin) {
  // begin [exercise 8.3]
  // Return the indices of all corners for which Eq. 8-4 holds. If these are more than four, return
  // the four that will have the smallest gap at the end of the step.
  todo("8.3");
  // end [exercise 8.3]
}

void solve_contact(std::vector<ContactRows>& corners, real mu, Body& body1, Body& body2) {
  // begin [exercise 8.3]
  // One iteration: for each corner solve t1, t2 and n, each with the velocities that the solve
  // before has left. You have written friction_impulse, clamp_sum (1.5) and apply_impulse (1.3).
  todo("8.3");
  // end [exercise 8.3]
}

// ---- rebound --------------------------------------------------------------------------------

real impact_speed(real C, real rate, real kick, real h) {
  // begin [exercise 8.4]
  // Return the speed at the ground. A true fall over the gap C begins with half a kick less than
  // `rate` and has the acceleration kick / h. Where the square of the speed is negative, return 0.
  todo("8.4");
  // end [exercise 8.4]
}

void rebound(std::vector<ContactRows>& corners, const std::vector<Bounce>& bounces, int iterations,
             Body& body1, Body& body2) {
  // begin [exercise 8.4]
  // The corners have been stopped. Solve their normal rows once more: each only pushes, and one
  // with a bounce gets its speed, but its sum stays below 1 + ratio times that which stopped it.
  todo("8.4");
  // end [exercise 8.4]
}

}  // namespace joints
