// Rows of a point by their definition: an entry is the rate of C while one velocity is 1 and the
// others are 0.
#pragma once

#include "engine/matrix.h"

namespace joints::testing {

/// The row of a rate that is linear in the velocities. \param rate of (v1, w1, v2, w2), as a Row
template <class Rate>
Row row_of(const Rate& rate) {
  Row J;
  for (vec3 Row::* block : {&Row::v1, &Row::w1, &Row::v2, &Row::w2})
    for (int k = 0; k < 3; ++k) {
      Row velocities;
      (velocities.*block)[k] = 1;
      (J.*block)[k] = rate(velocities);
    }
  return J;
}
/// The velocity of a point of body 2 relative to a point of body 1. \param r1, r2 their levers
inline vec3 relative_velocity(const Row& V, const vec3& r1, const vec3& r2) {
  return V.v2 + cross(V.w2, r2) - V.v1 - cross(V.w1, r1);
}
/// The row of the rate at which a point of body 2 moves along n relative to a point of body 1.
/// \param r1, r2 levers of the points
inline Row row_by_rates(const vec3& n, const vec3& r1, const vec3& r2) {
  return row_of([&](const Row& V) { return dot(n, relative_velocity(V, r1, r2)); });
}
/// The rows of a point of body 2 relative to one of body 1, along x, y and z.
inline Jacobian<3> point_by_rates(const vec3& r1, const vec3& r2) {
  Jacobian<3> J;
  for (int k = 0; k < 3; ++k) {
    vec3 along(0);
    along[k] = 1;
    J[k] = row_by_rates(along, r1, r2);
  }
  return J;
}

}  // namespace joints::testing
