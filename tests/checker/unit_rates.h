// Rows of a point by their definition: an entry is the rate of C while one velocity is 1 and the
// others are 0.
#pragma once

#include "engine/matrix.h"

namespace joints::testing {

/// The row of the rate at which a point of body 2 moves along n relative to a point of body 1.
/// \param r1, r2 levers of the points
inline Row row_by_rates(const vec3& n, const vec3& r1, const vec3& r2) {
  Row J;
  for (int k = 0; k < 3; ++k) {
    vec3 one(0);
    one[k] = 1;
    J.v2[k] = dot(n, one);
    J.w2[k] = dot(n, cross(one, r2));
    J.v1[k] = -dot(n, one);
    J.w1[k] = -dot(n, cross(one, r1));
  }
  return J;
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
