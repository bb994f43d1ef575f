// The joints that are made of chapter 10's parts. Given: there is nothing to edit here. A program
// contains only those that it names.
#pragma once

#include <numbers>
#include <tuple>

#include "chapters/10_own/own.h"
#include "joints/ball_joint.h"
#include "joints/hinge_joint.h"
#include "joints/part_joint.h"
#include "joints/slider_joint.h"

/// \addtogroup chapter10
/// @{
namespace joints {

// ---- universal joint -------------------------------------------------------------------------

/// Validates it. \throws std::invalid_argument unless both axes have the length 1
inline void check(const RightAngle& part) {
  require_unit("a1_local", part.a1_local);
  require_unit("a2_local", part.a2_local);
}

/// Makes the part of a universal joint in the present poses. \param anchor where the shafts' axes
/// meet [m, world] \param pin1 the pin of the cross in body 1, world, of any length
/// \param pin2 that in body 2; its part along pin1 is removed
/// \throws std::invalid_argument unless all are finite and the pins are not parallel
inline Composite<Point, RightAngle> cross_at(const Body& body1, const Body& body2,
                                             const vec3& anchor, const vec3& pin1,
                                             const vec3& pin2) {
  const vec3 a1 = normalize(pin1), across = pin2 - dot(pin2, a1) * a1, a2 = normalize(across);
  require(!(dot(across, across) <= real(1e-6) * dot(pin2, pin2)),
          "pin2: must not be parallel to pin1");
  return {point_at(body1, body2, anchor), {to_local(body1, a1), to_local(body2, a2)}};
}

// ---- parts that count turns ------------------------------------------------------------------

/// A joint of a part that counts turns. The part has two angles, `angle1` and `angle2`, or one of
/// them, or `angle`, and a function `count` like that of Gear. Once a step is solved, its new
/// velocities say where the angles will be at the end, to within less than half a turn: whoever
/// evaluates the part there, the solver or a projection, finds the right turn.
template <class Counted>
class CountingJoint : public PartJoint<Counted> {
 public:
  using PartJoint<Counted>::PartJoint;
  /// C at the present poses, with all turns until the end of the last step.
  real error(const Bodies& bodies) const {
    return this->part.error(bodies[this->body1], bodies[this->body2]);
  }
  /// Measures again where position projection has moved the bodies.
  void after_projection(const Bodies& bodies) override { count(bodies, 0); }
  /// Appends nothing. With the new velocities it expects the angles at the end of the step.
  void activate_missed_limits(const Bodies& bodies, real h, Blocks&) override {
    turns(this->part) = turns(begin_);
    count(bodies, h);
  }

 protected:
  void update_active_rows(const Bodies& bodies, real) override {
    count(bodies, 0);
    turns(begin_) = turns(this->part);
  }
  /// Saves or restores the impulses and the turns.
  void serialize(StateStream& stream) override {
    PartJoint<Counted>::serialize(stream);
    std::apply([&](auto&... expected) { stream(expected...); }, turns(this->part));
  }

 private:
  void count(const Bodies& bodies, real h) {
    this->part.count(bodies[this->body1], bodies[this->body2], h);
  }
  static auto turns(Counted& part) {
    if constexpr (requires { part.angle2; })
      return std::tie(part.angle1.expected, part.angle2.expected);
    else if constexpr (requires { part.angle1; })
      return std::tie(part.angle1.expected);
    else
      return std::tie(part.angle.expected);
  }
  Counted begin_ = this->part;  // its `expected` are those when the step began
};

/// Validates it. \throws std::invalid_argument unless its angles are valid, its ratio is not 0
inline void check(const Gear& gear) {
  check(gear.angle1);
  check(gear.angle2);
  require(finite(gear.ratio) && gear.ratio != 0, "ratio", gear.ratio,
          "must be finite and not 0 [1]");
}
/// Two wheels that mesh, on axles of a fixed housing: each wheel has a hinge of its own. On a
/// housing that moves the row would need three bodies, and reduced coordinates reject it, too: give
/// the hinge of wheel 2 a servo instead, with ratio times the angle of wheel 1 as its target before
/// every step. Wheel 2 then follows some steps behind, and wheel 1 feels nothing of it.
using GearJoint = CountingJoint<Gear>;
/// The angle of a body about an axle of the fixed housing, 0 in its present orientation.
/// \param axle direction, world, of any length
inline HingeAngle angle_on(const Body& body, const vec3& axle) {
  return angle_about(Body{}, body, axle);
}
/// Makes a gear of two wheels in their present poses. \param axle1 direction, world
/// \param axle2 the same of wheel 2 \param ratio turns of wheel 2 per turn of wheel 1
inline Gear gear_on(const Body& body1, const vec3& axle1, const Body& body2, const vec3& axle2,
                    real ratio) {
  return {angle_on(body1, axle1), angle_on(body2, axle2), ratio};
}

/// The arguments of a GearJoint: two axles in world space, and the ratio.
inline Gear make(std::type_identity<Gear>, const Body& body1, const Body& body2, const vec3& axle1,
                 const vec3& axle2, real ratio) {
  return gear_on(body1, axle1, body2, axle2, ratio);
}

/// Validates it. \throws std::invalid_argument unless its parts are valid, its lead finite
inline void check(const Screw& screw) {
  check(screw.slide);
  check(screw.angle);
  require(finite(screw.lead), "lead", screw.lead, "must be finite [m]");
}
/// The row of a screw. A PartJoint<Composite<Line, Axis>> holds the nut on the axis.
using ScrewJoint = CountingJoint<Screw>;
/// Makes a screw of two bodies in their present poses. \param anchor a point of the axis [m, world]
/// \param axis direction, world, of any length \param lead displacement per turn [m]
inline Screw screw_along(const Body& body1, const Body& body2, const vec3& anchor,
                         const vec3& axis, real lead) {
  const Point at = point_at(body1, body2, anchor);
  const HingeAngle angle = angle_about(body1, body2, axis);
  return {{at.anchor1_local, at.anchor2_local, angle.a1_local}, angle, lead};
}

/// The arguments of a ScrewJoint: a point and the direction of its axis, world, and the lead.
inline Screw make(std::type_identity<Screw>, const Body& body1, const Body& body2,
                  const vec3& anchor, const vec3& axis, real lead) {
  return screw_along(body1, body2, anchor, axis, lead);
}

// ---- cone ------------------------------------------------------------------------------------

/// Validates it. \throws std::invalid_argument unless the axes are unit, the limit in range
inline void check(const Cone& cone) {
  require_unit("a1_local", cone.a1_local);
  require_unit("a2_local", cone.a2_local);
  require(cone.limit > 0 && cone.limit < std::numbers::pi_v<real>, "limit", cone.limit,
          "must be above 0 and below pi [rad]");
}
/// Rows of a one-sided angular part for the end of a step. Its own row is exact at the start; if
/// the new velocities would violate the part at the end all the same, up to `most` rows for the
/// pose there are added, one after the other.
class EndRows {
 public:
  static constexpr int most = 12;                ///< rows in a step
  static constexpr real tolerance = real(2e-4);  ///< a violation that adds no row [rad]

  /// Appends a row if the part is kept now, but would not be at the end of the step. With E the end
  /// of the step, J_E the slope of C there with respect to the velocities, and C_E the present C
  /// there: C_E + h J_E (V_new - V) >= 0, a row with C = C_E - h J_E V (Eq. 10-8). Where that is
  /// negative, the turn is too long for a slope: then C = 0.
  /// \param h step [s] \param target of the row \param sign of its impulse in sum()
  template <class Part>
  void append(const Part& part, const Bodies& bodies, BodyId body1, BodyId body2, real h,
              const RowSettings& target, Blocks& blocks, real sign = 1) {
    static_assert(Part::rows == 1 && Part::one_sided && Part::form == Form::angular);
    const Body &a = bodies[body1], &b = bodies[body2];
    Body end1 = a, end2 = b;
    integrate_pose(end1, h);
    integrate_pose(end2, h);
    const real C = part.error(end1, end2);
    if (count_ == most || C > -tolerance || part.error(a, b) < -tolerance) return;
    const vec3 n = part.jacobian(end1, end2).w1;
    const Row J{vec3(0), before_turn(h * a.w, n), vec3(0), -before_turn(h * b.w, n)};
    const real slack = std::max(C - h * row_velocity(J, a, b), real(0));
    signs_[count_] = sign;
    axes_[count_] = J.w2;
    blocks.append<1>(bodies, body1, body2, {{J}}, {slack}, target, &impulse_[count_++]);
  }
  /// Begins a step without any.
  void clear() { impulse_ = {}, count_ = 0; }
  /// The sum of their impulses, each with its sign [N m s].
  real sum() const {
    real out = 0;
    for (int k = 0; k < most; ++k) out += signs_[k] * impulse_[k];
    return out;
  }
  /// The change of the angular momentum of body 2 by all of them [N m s, world].
  vec3 twist() const {
    vec3 out(0);
    for (int k = 0; k < most; ++k) out += impulse_[k] * axes_[k];
    return out;
  }
  /// Saves or restores the impulses.
  void serialize(StateStream& stream) { stream(impulse_, signs_, axes_); }

 private:
  // The slope of n.(rotation at the end of a turn) with respect to the vector of the turn: the
  // transposed left Jacobian of the exponential map, times n.
  static vec3 before_turn(const vec3& turn, const vec3& n) {
    const real angle = length(turn);
    if (angle < real(1e-4)) return n;
    const vec3 u = turn / angle;
    const real s = std::sin(angle) / angle, c = (1 - std::cos(angle)) / angle;
    return s * n + (1 - s) * dot(u, n) * u - c * cross(u, n);
  }
  Vector<most> impulse_{}, signs_{};  // written by the solver through the blocks; see sum()
  std::array<vec3, most> axes_{};     // J.w2 of each, world
  int count_ = 0;                     // of this step
};

/// Keeps an axis of body 2 within a cone about an axis of body 1; add it to a ball joint.
class ConeJoint : public PartJoint<Cone> {
 public:
  using PartJoint<Cone>::PartJoint;
  /// The force of all its rows in the last step [N m]: the sum of their impulses over the time.
  Vector<1> forces() const { return {mean_force(impulse()[0] + end_.sum())}; }
  /// The torque on body 2 in the last step [N m, world]. The rows for the end of the step have
  /// directions of their own.
  vec3 torque() const {
    const real duration = impulse_duration();
    return duration > 0 ? (impulse()[0] * axis_ + end_.twist()) / duration : vec3(0);
  }
  /// Appends rows for the end of the step.
  void activate_missed_limits(const Bodies& bodies, real h, Blocks& blocks) override {
    end_.append(part, bodies, body1, body2, h, hold(0), blocks);
  }

 protected:
  void update_active_rows(const Bodies& bodies, real) override {
    axis_ = part.jacobian(bodies[body1], bodies[body2]).w2;
    end_.clear();
  }
  void deactivate() override { end_.clear(); }
  /// Saves or restores the impulses of all rows.
  void serialize(StateStream& stream) override {
    PartJoint::serialize(stream);
    stream(axis_);
    end_.serialize(stream);
  }

 private:
  friend class ConeTwistJoint;
  EndRows end_;
  vec3 axis_{0};  // J.w2 of the row, world
};
/// Makes a cone about a direction in the present poses. \param axis world, of any length
/// \param limit the greatest swing [rad]
inline Cone cone_about(const Body& body1, const Body& body2, const vec3& axis, real limit) {
  return {normalize(to_local(body1, axis)), normalize(to_local(body2, axis)), limit};
}

/// As in `world.add<ConeJoint>(a, b, axis, 1)`.
inline Cone make(std::type_identity<Cone>, const Body& body1, const Body& body2, const vec3& axis,
                 real limit) {
  return cone_about(body1, body2, axis, limit);
}

// ---- a part of the reader's own --------------------------------------------------------------

/// A joint of a part that is known only when the program runs.
class OwnJoint : public Joint {
 public:
  OwnPart part;  ///< the geometry

  /// Of a part. \throws std::invalid_argument unless the part has 1 to 6 rows and both functions
  OwnJoint(BodyId body1, BodyId body2, const OwnPart& part) : Joint(body1, body2), part(part) {
    require(part.rows >= 1 && part.rows <= 6 && part.error && part.jacobian,
            "part: must have 1 to 6 rows and the functions error and jacobian");
  }
  void append(const Bodies& bodies, Blocks& blocks) const override { append_if<1>(bodies, blocks); }
  Stats stats() const override { return {.bounded = part.one_sided}; }  ///< a bound, or none

 protected:
  void serialize(StateStream& stream) override { stream(impulse_); }

 private:
  // A block needs to know its number of rows when it is compiled.
  template <int N>
  void append_if(const Bodies& bodies, Blocks& blocks) const {
    if constexpr (N <= 6) {
      if (part.rows != N) return append_if<N + 1>(bodies, blocks);
      const std::array<real, 6> C = part.error(bodies[body1], bodies[body2]);
      const std::array<Row, 6> rows = part.jacobian(bodies[body1], bodies[body2]);
      Jacobian<N> J;
      Vector<N> first;
      std::copy_n(rows.begin(), N, J.row.begin());
      std::copy_n(C.begin(), N, first.begin());
      blocks.append(bodies, body1, body2, J, first, hold(part.one_sided ? real(0) : -unbounded),
                    impulse_.data());
    }
  }
  mutable Vector<6> impulse_{};  // written by the solver through the block
};

}  // namespace joints
/// @}
