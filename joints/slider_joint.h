// The slider of the engine. Given: there is nothing to edit here.
#pragma once

#include "chapters/04_slider/slider.h"
#include "joints/driven_joint.h"

/// \addtogroup chapter4
/// @{
namespace joints {

/// Validates it. \throws std::invalid_argument unless anchors are finite, directions unit
inline void check(const Line& line) {
  require_finite("anchor1_local", line.anchor1_local, "must be finite [m]");
  require_finite("anchor2_local", line.anchor2_local, "must be finite [m]");
  require_unit("n1_local", line.n1_local);
  require_unit("n2_local", line.n2_local);
}
/// Validates it. \throws std::invalid_argument unless `start` is a unit quaternion
inline void check(const RotationLock& lock) { require_unit("start", lock.start); }
/// Validates it. \throws std::invalid_argument unless anchors are finite, a1_local is unit
inline void check(const Slide& slide) {
  require_finite("anchor1_local", slide.anchor1_local, "must be finite [m]");
  require_finite("anchor2_local", slide.anchor2_local, "must be finite [m]");
  require_unit("a1_local", slide.a1_local);
}

/// The largest m r^2 / I of a lever r in a joint with a lock [1]. Beyond it the rows that hold the
/// anchor depend on the lock but for rounding errors: of their K only 1/m does not.
constexpr real max_lever_share = sizeof(real) == 4 ? real(1e6) : real(1e10);
/// Validates a lever. \throws std::invalid_argument for an anchor too far from the centre of the
/// body \param lever from the centre to the anchor [m]
inline void check_lever(const char* anchor, const Body& body, const vec3& lever) {
  const vec3& inverse = body.inverse_inertia_local;
  require(!(dot(lever, lever) * std::max({inverse.x, inverse.y, inverse.z}) >
            max_lever_share * body.inverse_mass),
          anchor, length(lever),
          "must be nearer to the body's centre, or these numbers cannot tell its rows apart [m]");
}

/// Makes the part that keeps a point of body 2 on a line of body 1, which passes through the point
/// in the present poses. \param anchor [m, world] \param direction world, of any length
/// \throws std::invalid_argument unless both are finite and the direction is not zero
inline Line line_along(const Body& body1, const Body& body2, const vec3& anchor,
                       const vec3& direction) {
  require(finite(anchor), "anchor: must be finite [m]");
  const Axis axis = axis_along(body2, body1, direction);  // swapped: b and c are of body 1
  return {to_local(body1, anchor - body1.x), to_local(body2, anchor - body2.x), axis.b_local,
          axis.c_local};
}
/// Makes the displacement along that line, 0 in the present poses. The arguments are the same.
inline Slide slide_along(const Body& body1, const Body& body2, const vec3& anchor,
                         const vec3& direction) {
  const Line line = line_along(body1, body2, anchor, direction);
  return {line.anchor1_local, line.anchor2_local, cross(line.n1_local, line.n2_local)};
}

/// A slider: it holds a point on a line and the orientation, which removes five degrees of freedom.
/// The displacement along the line is free and may have limits [m] and a motor [m/s, N]. Errors:
/// Eq. 4-2 and Eq. 4-7. Rows: Eq. 4-4 and Eq. 4-8, and Eq. 4-11 for limit and motor. K: Eq. 3-8.
class SliderJoint : public DrivenJoint<Line, RotationLock, Slide> {
 public:
  /// A slider along a direction of the world. The anchors of both bodies are the same point of the
  /// world, so the displacement is zero at their present poses. \param anchor [m, world]
  /// \param direction world, of any length
  /// \throws std::invalid_argument unless both are finite and the direction is not zero
  SliderJoint(const Bodies& bodies, BodyId id1, BodyId id2, const vec3& anchor,
              const vec3& direction)
      : DrivenJoint(id1, id2, line_along(bodies[id1], bodies[id2], anchor, direction),
                    lock_of(bodies[id1], bodies[id2]),
                    slide_along(bodies[id1], bodies[id2], anchor, direction)) {}
  /// As DrivenJoint::check_input, and both levers by check_lever(). Both end at body 2's anchor.
  void check_input(const Bodies& bodies) const override {
    DrivenJoint::check_input(bodies);
    const Body &a = bodies.at(int(body1.slot)), &b = bodies.at(int(body2.slot));
    check_lever("anchor1_local", a, world_point(b, first.anchor2_local) - a.x);
    check_lever("anchor2_local", b, first.anchor2_local);
  }
};

}  // namespace joints
/// @}
