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

// ---- all corners of a body ------------------------------------------------------------------

std::vector<int> live_corners(const std::vector<real>& C, const std::vector<real>& rate, real h,
                              real margin) {
  // begin [exercise 8.3]
  // Return the indices of all corners for which Eq. 8-4 holds. If these are more than four, return
  // the four that will have the smallest gap at the end of the step.
  std::vector<int> live;
  std::vector<real> later;
  for (std::size_t k = 0; k < C.size(); ++k) {
    later.push_back(C[k] + h * rate[k]);
    if (later[k] < margin * h) live.push_back(int(k));  // Eq. 8-4
  }
  while (live.size() > 4) {
    std::size_t highest = 0;
    for (std::size_t j = 1; j < live.size(); ++j)
      if (later[std::size_t(live[j])] > later[std::size_t(live[highest])]) highest = j;
    live.erase(live.begin() + int(highest));
  }
  return live;
  // end [exercise 8.3]
}

void solve_contact(std::vector<ContactRows>& corners, real mu, Body& body1, Body& body2) {
  // begin [exercise 8.3]
  // One iteration: for each corner solve t1, t2 and n, each with the velocities that the solve
  // before has left. You have written friction_impulse, clamp_sum (1.5) and apply_impulse (1.3).
  for (ContactRows& corner : corners) {
    for (int i = 0; i < 2; ++i) {
      const real rate = row_velocity(corner.J[i], body1, body2);
      const real change = friction_impulse(rate, corner.K[i], mu, corner.sum[2], corner.sum[i]);
      apply_impulse(corner.J[i], change, body1, body2);
    }
    const real error = row_velocity(corner.J[2], body1, body2) + corner.bias;
    apply_impulse(corner.J[2], clamp_sum(-error / corner.K[2], corner.sum[2]), body1, body2);
  }
  // end [exercise 8.3]
}

// ---- rebound --------------------------------------------------------------------------------

real impact_speed(real C, real rate, real kick, real h) {
  // begin [exercise 8.4]
  // Return the speed at the ground. A true fall over the gap C begins with half a kick less than
  // `rate` and has the acceleration kick / h. Where the square of the speed is negative, return 0.
  const real now = rate - kick / 2;
  return std::sqrt(std::max(real(0), now * now - 2 * kick / h * C));  // Eq. 8-9
  // end [exercise 8.4]
}

void rebound(std::vector<ContactRows>& corners, const std::vector<Bounce>& bounces, int iterations,
             Body& body1, Body& body2) {
  // begin [exercise 8.4]
  // The corners have been stopped. Solve their normal rows once more: each only pushes, and one
  // with a bounce gets its speed, but its sum stays below 1 + ratio times that which stopped it.
  std::vector<real> most;
  for (std::size_t k = 0; k < corners.size(); ++k)
    most.push_back((1 + bounces[k].ratio) * corners[k].sum[2]);
  for (int i = 0; i < iterations; ++i)
    for (std::size_t k = 0; k < corners.size(); ++k) {
      ContactRows& corner = corners[k];
      const real missing = bounces[k].speed - row_velocity(corner.J[2], body1, body2);
      const real before = corner.sum[2];
      corner.sum[2] = std::max(real(0), before + missing / corner.K[2]);
      if (bounces[k].speed > 0) corner.sum[2] = std::min(corner.sum[2], most[k]);
      apply_impulse(corner.J[2], corner.sum[2] - before, body1, body2);
    }
  // end [exercise 8.4]
}

}  // namespace joints
