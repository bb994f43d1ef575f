// Joints with several free coordinates: universal joint, strut, cone and twist, six degrees of
// freedom. Given: there is nothing to edit here.
#pragma once

#include "joints/distance_joint.h"
#include "joints/own_joint.h"
#include "joints/turned_coordinate.h"

/// \addtogroup chapter10
/// @{
namespace joints {

/// The rigid part of a joint that holds nothing: it has only free coordinates.
struct NoRows {};
/// A joint of no rows, below the coordinates of WithCoordinates.
template <>
class PartJoint<NoRows> : public Joint {
 public:
  /// Of a part. \throws std::invalid_argument for a joint of a body with itself
  PartJoint(BodyId body1, BodyId body2, NoRows) : Joint(body1, body2) {}
  void append(const Bodies&, Blocks&) const override {}
};

/// A rigid part, and any number of free coordinates, each with everything that may act on it. The
/// blocks are in the order drives, limits, rigid rows, because the block that is solved last is
/// satisfied best.
template <class Rigid, class... Coordinates>
class WithCoordinates : public PartJoint<Rigid> {
 public:
  /// Coordinate k, in the order of the template's arguments.
  template <std::size_t k>
  auto& coordinate() { return std::get<k>(free_); }
  /// The same, read-only.
  template <std::size_t k>
  const auto& coordinate() const { return std::get<k>(free_); }

  /// Measures the coordinates again after position projection.
  void after_projection(const Bodies& bodies) override {
    PartJoint<Rigid>::after_projection(bodies);
    for_each([&](auto& free) { free.after_projection(bodies); });
  }
  /// Appends the blocks of drives, limits and rigid rows that are live.
  void append(const Bodies& bodies, Blocks& blocks) const override {
    for_each([&](auto& free) { free.append_drives(bodies, blocks); });
    for_each([&](auto& free) { free.append_limit(bodies, blocks); });
    PartJoint<Rigid>::append(bodies, blocks);
    for_each([&](auto& free) { free.append_late(bodies, blocks); });
  }
  /// Appends limits that the new velocities would pass within this step.
  void activate_missed_limits(const Bodies& bodies, real h, Blocks& blocks) override {
    PartJoint<Rigid>::activate_missed_limits(bodies, h, blocks);
    for_each([&](auto& free) { free.late(bodies, h, blocks); });
  }
  /// Counts the limits and motors of all coordinates.
  Joint::Stats stats() const override {
    Joint::Stats out = PartJoint<Rigid>::stats();
    for_each([&](auto& free) { free.report(out); });
    return out;
  }

 protected:
  /// Makes the joint from its parts.
  WithCoordinates(BodyId body1, BodyId body2, const Rigid& rigid, const Coordinates&... coordinates)
      : PartJoint<Rigid>(body1, body2, rigid),
        free_{Free<Coordinates>(*this, coordinates)...} {
    (check(coordinates), ...);
  }
  /// Chooses the rows of a step. \param h step [s]
  void update_active_rows(const Bodies& bodies, real h) override {
    PartJoint<Rigid>::update_active_rows(bodies, h);
    for_each([&](auto& free) { free.choose(bodies, h); });
  }
  /// Between two static bodies: no row is live.
  void deactivate() override {
    PartJoint<Rigid>::deactivate();
    for_each([](auto& free) { free.drop(); });
  }
  /// Saves or restores the coordinates and the impulses.
  void serialize(StateStream& stream) override {
    PartJoint<Rigid>::serialize(stream);
    for_each([&](auto& free) { free.serialize(stream); });
  }

 private:
  template <class Use>
  void for_each(const Use& use) const {
    std::apply([&](const auto&... free) { (use(free), ...); }, free_);
  }
  template <class Use>
  void for_each(const Use& use) {
    std::apply([&](auto&... free) { (use(free), ...); }, free_);
  }
  template <class Coordinate>
  using Free = std::conditional_t<Coordinate::form == Form::angular, TurnedCoordinate<Coordinate>,
                                  FreeCoordinate<Coordinate>>;
  std::tuple<Free<Coordinates>...> free_;
};

// ---- universal joint -------------------------------------------------------------------------

/// Connects two shafts that meet at an angle: a point and a right angle, four rows in one block.
/// The rotations about the two pins of its cross are free and may have limits, motors and springs.
/// Each of them is the twist of the relative rotation about its pin, exact while the other one is
/// below half a turn. Errors and rows: Eq. 2-1, 2-4 and 10-2, and Eq. 3-10 for the rotations.
class UniversalJoint
    : public WithCoordinates<Composite<Point, RightAngle>, HingeAngle, HingeAngle> {
 public:
  /// Makes it of a cross. \param anchor where the shafts' axes meet [m, world] \param pin1 the pin
  /// of the cross in body 1, world, any length \param pin2 in body 2, without its part along pin1
  /// \throws std::invalid_argument unless all are finite and the pins are not parallel
  UniversalJoint(const Bodies& bodies, BodyId id1, BodyId id2, const vec3& anchor,
                 const vec3& pin1, const vec3& pin2)
      : UniversalJoint(bodies[id1], bodies[id2], id1, id2,
                       cross_at(bodies[id1], bodies[id2], anchor, pin1, pin2)) {}
  auto& angle1() { return coordinate<0>(); }  ///< about the pin in body 1 [rad]
  auto& angle2() { return coordinate<1>(); }  ///< about the pin in body 2 [rad]

 private:
  UniversalJoint(const Body& body1, const Body& body2, BodyId id1, BodyId id2,
                 const Composite<Point, RightAngle>& rigid)
      : WithCoordinates(id1, id2, rigid,
                        angle_about(body1, body2, to_world(body1, rigid.second.a1_local)),
                        angle_about(body1, body2, to_world(body2, rigid.second.a2_local))) {}
};

// ---- strut -----------------------------------------------------------------------------------

/// The distance of two points. C = |p2 - p1| [m]; J = (-u^T, -(r1 x u)^T, u^T, (r2 x u)^T) with u
/// from p1 to p2, exact at every pose but length 0, where u and with it the row are 0; K = J M^-1
/// J^T [1/kg]. It is Eq. 1-13 for the length 0.
struct Length {
  vec3 anchor1_local{0};  ///< p1 [m, body space of body 1]
  vec3 anchor2_local{0};  ///< p2 [m, body space of body 2]

  static constexpr int rows = 1;            ///< one row, used by everything that acts on it
  static constexpr bool one_sided = false;  ///< false; the row of a limit is one-sided
  static constexpr Form form = Form::any;   ///< the form of its row
  /// C [m].
  real error(const Body& body1, const Body& body2) const { return rod().error(body1, body2); }
  /// Its slope.
  Row jacobian(const Body& body1, const Body& body2) const {
    return rod().jacobian(body1, body2);
  }

 private:
  Distance rod() const {
    return {.anchor1_local = anchor1_local, .anchor2_local = anchor2_local, .length = 0};
  }
};
/// Validates it. \throws std::invalid_argument unless both anchors are finite
inline void check(const Length& part) { check(Point{part.anchor1_local, part.anchor2_local}); }

/// The distance of two points as a free coordinate [m]: with a spring it is a suspension, with a
/// motor a cylinder, with an upper limit a rope, and with both a winch. It removes no degree of
/// freedom.
class StrutJoint : public WithCoordinates<NoRows, Length> {
 public:
  /// Makes it of two points. \param point1 of body 1 [m, world] \param point2 of body 2 [m, world]
  /// \throws std::invalid_argument unless both are finite
  StrutJoint(const Bodies& bodies, BodyId id1, BodyId id2, const vec3& point1, const vec3& point2)
      : WithCoordinates(id1, id2, {}, {to_local(bodies[id1], point1 - bodies[id1].x),
                                       to_local(bodies[id2], point2 - bodies[id2].x)}) {}
  /// See Joint. A distance is never below zero, and neither is its upper limit.
  void check_input(const Bodies& bodies) const override {
    WithCoordinates::check_input(bodies);
    const real upper = coordinate<0>().limits().upper;
    require(upper >= 0, "length: upper limit", upper, "must not be negative [m]");
  }
  auto& length() { return coordinate<0>(); }  ///< the distance of the two points [m]
};

// ---- swing and twist -------------------------------------------------------------------------

/// Three perpendicular unit vectors in body space of body 1: the first along an axis, the second in
/// the plane of the axis and another direction. \param axis, across world, of any length
/// \throws std::invalid_argument unless both are finite, not zero and not parallel
inline std::array<vec3, 3> frame_of(const Body& body1, const vec3& axis, const vec3& across) {
  require(finite(axis) && finite(across) && axis != vec3(0) && across != vec3(0),
          "axis, across: must be finite and not zero");
  const vec3 x = normalize(axis), z = cross(x, normalize(across));
  require(dot(z, z) > real(1e-6), "across: must not be parallel to the axis");
  return {to_local(body1, x), to_local(body1, cross(normalize(z), x)),
          to_local(body1, normalize(z))};
}

/// A shoulder or a hip: holds a point, keeps the swing within a cone, and the twist between limits.
/// Twist and both components of the swing may have limits, drives and springs. It removes three
/// degrees of freedom. Rows: Eq. 2-4 for the point, Eq. 10-7 and 10-8 for the cone, Eq. 3-10 for
/// the twist, which is exact below half a turn of swing.
class ConeTwistJoint : public WithCoordinates<Point, HingeAngle, SwingAngle, SwingAngle> {
 public:
  /// Swing and twist are 0 in the present poses. \param anchor [m, world] \param axis of the cone,
  /// world, of any length \param across the direction about which the first component of the swing
  /// is measured; its part along the axis is removed \param limit the greatest swing [rad], above
  /// 0; pi or more for no cone
  /// \throws std::invalid_argument unless all are finite and across is not parallel to the axis
  ConeTwistJoint(const Bodies& bodies, BodyId id1, BodyId id2, const vec3& anchor,
                 const vec3& axis, const vec3& across, real limit)
      : ConeTwistJoint(bodies[id1], bodies[id2], id1, id2, anchor,
                       frame_of(bodies[id1], axis, across), limit) {}
  auto& twist() { return coordinate<0>(); }   ///< rotation about the axis [rad]
  auto& swing1() { return coordinate<1>(); }  ///< rotation about `across` [rad]
  auto& swing2() { return coordinate<2>(); }  ///< rotation about the axis x `across` [rad]
  /// Sets the greatest swing [rad], above 0; pi or more for no cone.
  void set_cone(real limit) {
    require(limit > 0 && finite(limit), "limit", limit, "must be positive and finite [rad]");
    limited_ = limit < std::numbers::pi_v<real>;
    if (limited_) cone_.part.limit = limit;
  }
  /// The torque of the cone on body 2 in the last step [N m, world].
  vec3 cone_torque() const { return limited_ ? cone_.torque() : vec3(0); }

  void append(const Bodies& bodies, Blocks& blocks) const override {
    if (limited_) cone_.append(bodies, blocks);
    WithCoordinates::append(bodies, blocks);
  }
  void activate_missed_limits(const Bodies& bodies, real h, Blocks& blocks) override {
    WithCoordinates::activate_missed_limits(bodies, h, blocks);
    if (limited_) cone_.activate_missed_limits(bodies, h, blocks);
  }
  Stats stats() const override {
    Stats out = WithCoordinates::stats();
    out.bounded = limited_;
    return out;
  }

 protected:
  void update_active_rows(const Bodies& bodies, real h) override {
    WithCoordinates::update_active_rows(bodies, h);
    cone_.body1 = body1, cone_.body2 = body2;
    cone_.beta = beta, cone_.frequency = frequency, cone_.damping = damping, cone_.push = push;
    cone_.begin_step(bodies, h, impulse_duration());
  }
  void deactivate() override {
    WithCoordinates::deactivate();
    cone_.deactivate();
  }
  void serialize(StateStream& stream) override {
    WithCoordinates::serialize(stream);
    cone_.serialize(stream);
    stream(limited_);
  }

 private:
  ConeTwistJoint(const Body& a, const Body& b, BodyId id1, BodyId id2, const vec3& anchor,
                 const std::array<vec3, 3>& frame, real limit)
      : WithCoordinates(id1, id2, point_at(a, b, anchor), angle_about(a, b, to_world(a, frame[0])),
                        {frame[0], frame[1], normalize(to_local(b, to_world(a, frame[0])))},
                        {frame[0], frame[2], normalize(to_local(b, to_world(a, frame[0])))}),
        cone_(id1, id2, cone_about(a, b, to_world(a, frame[0]), 1)) {
    swing1().set_twist(twist());
    swing2().set_twist(twist());
    set_cone(limit);
  }
  ConeJoint cone_;  // appends its rows, and is never in the world itself
  bool limited_ = true;
};

// ---- six degrees of freedom ------------------------------------------------------------------

/// Six free coordinates: the displacement along three axes of body 1, and the rotation as a twist
/// about the first axis and a swing about the other two. Each is free, limited, locked (equal
/// limits) or driven. All are free in the beginning. Rows: Eq. 4-11, Eq. 3-10 and those of
/// SwingAngle, exact below half a turn of swing.
class SixDofJoint : public WithCoordinates<NoRows, Slide, Slide, Slide, HingeAngle, SwingAngle,
                                               SwingAngle> {
 public:
  /// All coordinates are 0 in the present poses. \param anchor common point [m, world]
  /// \param axis the first axis, world, of any length \param across the second one; its part along
  /// the first is removed
  /// \throws std::invalid_argument unless all are finite and across is not parallel to the axis
  SixDofJoint(const Bodies& bodies, BodyId id1, BodyId id2, const vec3& anchor,
                  const vec3& axis, const vec3& across)
      : SixDofJoint(bodies[id1], bodies[id2], id1, id2, point_at(bodies[id1], bodies[id2],
                                                                     anchor),
                        frame_of(bodies[id1], axis, across)) {}
  auto& slide1() { return coordinate<0>(); }  ///< displacement along the first axis [m]
  auto& slide2() { return coordinate<1>(); }  ///< displacement along the second axis [m]
  auto& slide3() { return coordinate<2>(); }  ///< displacement along the third axis [m]
  auto& twist() { return coordinate<3>(); }   ///< rotation about the first axis [rad]
  auto& swing2() { return coordinate<4>(); }  ///< rotation about the second axis [rad]
  auto& swing3() { return coordinate<5>(); }  ///< rotation about the third axis [rad]

 private:
  SixDofJoint(const Body& a, const Body& b, BodyId id1, BodyId id2, const Point& at,
                  const std::array<vec3, 3>& frame)
      : WithCoordinates(id1, id2, {}, {at.anchor1_local, at.anchor2_local, frame[0]},
                        {at.anchor1_local, at.anchor2_local, frame[1]},
                        {at.anchor1_local, at.anchor2_local, frame[2]},
                        angle_about(a, b, to_world(a, frame[0])),
                        {frame[0], frame[1], normalize(to_local(b, to_world(a, frame[0])))},
                        {frame[0], frame[2], normalize(to_local(b, to_world(a, frame[0])))}) {
    swing2().set_twist(twist());
    swing3().set_twist(twist());
  }
};
/// Its name before version 0.10.
using SixDegreesJoint [[deprecated("write SixDofJoint")]] = SixDofJoint;


}  // namespace joints
/// @}
