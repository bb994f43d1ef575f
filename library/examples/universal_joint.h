// A user-defined joint: the universal joint, by which one shaft drives another at an angle.
#pragma once

#include <joints.h>

namespace mine {
using namespace joints;

/// Keeps an axis of body 1 at right angles to an axis of body 2. Removes one degree of freedom.
/// C = a1.a2 [1]; J = (0, (a1 x a2)^T, 0, -(a1 x a2)^T), exact at every pose. Where the two axes
/// are parallel, J is zero and the row has no effect.
struct RightAngle {
  vec3 a1_local{1, 0, 0};  ///< unit, body space of body 1
  vec3 a2_local{0, 1, 0};  ///< unit, body space of body 2

  static constexpr int rows = 1;            ///< degrees of freedom that it removes
  static constexpr bool one_sided = false;  ///< it acts in both directions
  static constexpr Form form = Form::angular;  ///< v1 = v2 = 0 and w1 = -w2
  real error(const Body& body1, const Body& body2) const {
    return dot(to_world(body1, a1_local), to_world(body2, a2_local));
  }
  Row jacobian(const Body& body1, const Body& body2) const {
    const vec3 across = cross(to_world(body1, a1_local), to_world(body2, a2_local));
    return {vec3(0), across, vec3(0), -across};
  }
};

/// Holds a point, and keeps two axes at right angles: four rows in one block.
using UniversalJoint = PartJoint<Composite<Point, RightAngle>>;

/// \throws std::invalid_argument unless both axes have the length 1
inline void check(const RightAngle& part) {
  require_unit("a1_local", part.a1_local);
  require_unit("a2_local", part.a2_local);
}

/// Joins two shafts in their present poses. \param anchor where the shafts' axes meet [m, world]
/// \param axis1 the pin of the cross in body 1, unit, world \param axis2 that in body 2
inline Composite<Point, RightAngle> cross_at(const Body& body1, const Body& body2,
                                             const vec3& anchor, const vec3& axis1,
                                             const vec3& axis2) {
  return {point_at(body1, body2, anchor), {to_local(body1, axis1), to_local(body2, axis2)}};
}

}  // namespace mine
