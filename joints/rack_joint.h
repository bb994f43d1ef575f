// Two more joints made by the recipe: a rack with its pinion, and a rope over two pulleys. Given:
// there is nothing to edit here.
#pragma once

#include "chapters/01_distance/rods.h"
#include "joints/own_joint.h"

/// \addtogroup chapter10
/// @{
namespace joints {

/// A pinion (body 1) on an axle of a fixed housing moves a rack (body 2) along a fixed direction.
/// Removes one degree of freedom.
///
/// C = d.(p2 - start) - radius angle1 [m], p2 = x2 + r2; J = (0, -radius g1^T, d^T, (r2 x d)^T),
/// exact at every pose below half a turn of misalignment; K = radius^2 g1.I1^-1 g1 + 1/m2 +
/// (r2 x d).I2^-1 (r2 x d) [1/kg], never singular while a body can move. Like a gear it exchanges
/// momentum with its housing. Source: ours, from Eq. 3-10 and Eq. 4-11.
struct Rack {
  HingeAngle angle1;        ///< of the pinion about its axle, whose direction is in world space
  vec3 direction{1, 0, 0};  ///< d, of the rack, unit, world
  vec3 start{0};            ///< where the rack's point is at angle 0 [m, world]
  vec3 anchor2_local{0};    ///< that point of the rack [m, body space]
  real radius = 1;          ///< of the pinion [m]; negative: the rack runs the other way

  static constexpr int rows = 1;            ///< degrees of freedom that it removes
  static constexpr bool one_sided = false;  ///< both signs of impulse are allowed
  static constexpr Form form = Form::any;   ///< one body turns, the other one slides
  /// C [m].
  real error(const Body& body1, const Body& body2) const {
    return dot(direction, world_point(body2, anchor2_local) - start) -
           radius * angle_of(angle1, body1);
  }
  /// Its slope.
  Row jacobian(const Body& body1, const Body& body2) const {
    return {vec3(0), -radius * slope_of(angle1, body1), direction,
            cross(to_world(body2, anchor2_local), direction)};
  }
  /// Keeps the turns of the pinion. \param h step [s]
  void count(const Body& body1, const Body&, real h) {
    const real rate = dot(body1.w, slope_of(angle1, body1));
    angle1.expected = angle_of(angle1, body1) + rate * h;
  }
};
/// Validates it. \throws std::invalid_argument unless the angle is valid, the direction has length
/// 1, the rest is finite and the radius not 0
inline void check(const Rack& rack) {
  check(rack.angle1);
  require_unit("direction", rack.direction);
  require(finite(rack.start) && finite(rack.anchor2_local), "start: must be finite [m]");
  require(finite(rack.radius) && rack.radius != 0, "radius", rack.radius,
          "must be finite and not 0 [m]");
}
/// The arguments of a RackJoint, for the present poses.
/// \param axle direction of the pinion's axle, world, of any length \param direction of the rack,
/// world, of any length \param radius [m]
inline Rack make(std::type_identity<Rack>, const Body& pinion, const Body& rack, const vec3& axle,
                 const vec3& direction, real radius) {
  return {angle_on(pinion, axle), normalize(direction), rack.x, vec3(0), radius};
}
/// A pinion, which has a hinge of its own, and a rack, which has a slider of its own. On a housing
/// that moves, give the slider a servo instead, as for a GearJoint: its target is radius times the
/// angle of the pinion.
using RackJoint = CountingJoint<Rack>;

/// A rope from body 1 over two fixed pulleys to body 2. One-sided: it only pulls. Removes one
/// degree of freedom while it is taut.
///
/// l1 = |p1 - top1|, l2 = |p2 - top2|; C = length - l1 - ratio l2 >= 0 [m]; with u = (p - top)/l,
/// J = -(u1^T, (r1 x u1)^T, ratio u2^T, ratio (r2 x u2)^T), exact at every pose; K = J M^-1 J^T
/// [1/kg]. Singular where a body is at its pulley: there u has no direction, and is taken as 0.
/// Source: the pulley joint of Box2D (Catto), in three dimensions and as an inequality.
struct Pulley {
  vec3 top1{0}, top2{0};  ///< where the rope leaves the pulleys [m, world]
  vec3 anchor1_local{0};  ///< where it is tied to body 1 [m, body space]
  vec3 anchor2_local{0};  ///< where it is tied to body 2 [m, body space]
  real length = 1;        ///< l1 + ratio l2 of the taut rope [m]
  real ratio = 1;         ///< body 2 moves 1/ratio times as far as body 1 [1]: a block and tackle

  static constexpr int rows = 1;           ///< degrees of freedom that it removes while taut
  static constexpr bool one_sided = true;  ///< it only pulls
  static constexpr Form form = Form::any;  ///< each body has a direction of its own
  /// C, the slack [m].
  real error(const Body& body1, const Body& body2) const {
    return length - glm::length(world_point(body1, anchor1_local) - top1) -
           ratio * glm::length(world_point(body2, anchor2_local) - top2);
  }
  /// Its slope.
  Row jacobian(const Body& body1, const Body& body2) const {
    const vec3 u1 = direction(world_point(body1, anchor1_local) - top1);
    const vec3 u2 = ratio * direction(world_point(body2, anchor2_local) - top2);
    return {-u1, -cross(to_world(body1, anchor1_local), u1), -u2,
            -cross(to_world(body2, anchor2_local), u2)};
  }
};
/// Validates it. \throws std::invalid_argument unless all is finite, length and ratio > 0
inline void check(const Pulley& pulley) {
  require(finite(pulley.top1) && finite(pulley.top2), "top1, top2: must be finite [m]");
  require(finite(pulley.anchor1_local) && finite(pulley.anchor2_local),
          "anchor1_local, anchor2_local: must be finite [m]");
  require(pulley.length > 0 && pulley.length < unbounded, "length", pulley.length,
          "must be positive [m]");
  require(pulley.ratio > 0 && pulley.ratio < unbounded, "ratio", pulley.ratio,
          "must be positive [1]");
}
/// The arguments of a PulleyJoint: a rope that is taut in the present poses.
/// \param top1, top2 where it leaves the pulleys [m, world]
/// \param point1, point2 where it is tied to the bodies [m, world] \param ratio [1]
inline Pulley make(std::type_identity<Pulley>, const Body& body1, const Body& body2,
                   const vec3& top1, const vec3& top2, const vec3& point1, const vec3& point2,
                   real ratio) {
  return {top1, top2, to_local(body1, point1 - body1.x), to_local(body2, point2 - body2.x),
          length(point1 - top1) + ratio * length(point2 - top2), ratio};
}
/// A rope over two pulleys. Where they move, set part.top1 and part.top2 before every step: the
/// rope follows some steps behind, and the pulleys feel nothing of it, which would need a row of
/// four bodies.
using PulleyJoint = PartJoint<Pulley>;

}  // namespace joints
/// @}
