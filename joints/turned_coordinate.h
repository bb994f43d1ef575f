// Angles of joints whose bodies also rotate about other axes. Given: there is nothing to edit here.
#pragma once

#include <utility>
#include <variant>

#include "joints/own_joint.h"

/// \addtogroup chapter10
/// @{
namespace joints {

/// One component of the swing: of the shortest rotation that takes an axis of body 1 to an axis of
/// body 2, about a direction perpendicular to the first axis.
///
/// c = a1.a2, theta = arccos c, kappa = theta / sin theta; C = kappa (a1 x a2).n1 [rad];
/// J = (0, -g^T, 0, g^T), g = kappa' ((a1 x a2).n1) (a2 x a1) + kappa a2 x (n1 x a1) with kappa' =
/// (kappa c - 1)/(1 - c^2), exact at every swing below pi; K = g.(I1^-1 + I2^-1) g [1/(kg m^2)].
/// At pi the direction of the swing is arbitrary and kappa is infinite. With the twist about a1
/// (HingeAngle) two of them are coordinates of the orientation. Source: swing-twist decomposition;
/// the slope is ours.
struct SwingAngle {
  vec3 a1_local{1, 0, 0};  ///< unit, body space of body 1
  vec3 n1_local{0, 1, 0};  ///< unit, perpendicular to a1, body space of body 1
  vec3 a2_local{1, 0, 0};  ///< unit, body space of body 2

  static constexpr int rows = 1;               ///< one row, used by everything that acts on it
  static constexpr bool one_sided = false;     ///< false; the row of a limit is one-sided
  static constexpr Form form = Form::angular;  ///< the form of its row
  /// C [rad].
  real error(const Body& body1, const Body& body2) const {
    const vec3 a1 = to_world(body1, a1_local), a2 = to_world(body2, a2_local);
    return kappa(a1, a2) * dot(cross(a1, a2), to_world(body1, n1_local));
  }
  /// Its slope.
  Row jacobian(const Body& body1, const Body& body2) const {
    const vec3 a1 = to_world(body1, a1_local), a2 = to_world(body2, a2_local);
    const vec3 n1 = to_world(body1, n1_local), across = cross(a1, a2);
    const real c = dot(a1, a2), square = dot(across, across), k = kappa(a1, a2);
    // near 0 the difference k c - 1 would be lost in rounding
    const real slope = square > real(1e-4) || c < 0 ? (k * c - 1) / square
                                                    : -(1 + square * real(0.4)) / 3;
    const vec3 g = -slope * dot(across, n1) * across + k * cross(a2, cross(n1, a1));
    return {vec3(0), -g, vec3(0), g};
  }

 private:
  static real kappa(const vec3& a1, const vec3& a2) {
    const real sine = length(cross(a1, a2));
    return sine > real(1e-6) ? std::atan2(sine, dot(a1, a2)) / sine : real(1);
  }
};
/// Validates it. \throws std::invalid_argument unless the three vectors have length 1
inline void check(const SwingAngle& part) {
  require_unit("a1_local", part.a1_local);
  require_unit("n1_local", part.n1_local);
  require_unit("a2_local", part.a2_local);
}

/// An angle that is held, exact at every swing: a twist at any angle or, beside a twist that is
/// held at zero, a component of the swing at zero. The rows of these angles (Eq. 3-10, SwingAngle)
/// grow without bound near half a turn of swing, and at it the angles are arbitrary; this one is
/// not.
///
/// q = (w, v) is the rotation of body 2 relative to body 1 from the pose in which the angle is
/// zero, and a = a1_local. C = 2 sign (cos(at/2) v.a - sin(at/2) w) [1], about the difference of
/// the angles [rad] where it and the swing are small; with g = sign (cos(at/2) (w a + v x a) +
/// sin(at/2) v) in the axes of body 1, J = (0, -g^T, 0, g^T), and |g| = 1 where C = 0;
/// K = g.(I1^-1 + I2^-1) g [1/(kg m^2)]. It knows no whole turns. Source: q' = Omega q / 2; the
/// error is ours.
struct HeldAngle {
  HingeAngle angle;  ///< the axis, and the pose in which the angle is zero
  real at = 0;       ///< where it is held [rad]
  real sign = 1;     ///< such that a positive impulse increases the angle

  static constexpr int rows = 1;               ///< one row
  static constexpr bool one_sided = false;     ///< it acts in both directions
  static constexpr Form form = Form::angular;  ///< the form of its row
  /// C [1].
  real error(const Body& body1, const Body& body2) const {
    const quat q = rotation(body1, body2);
    return 2 * sign * (std::cos(at / 2) * along_axis(q) - std::sin(at / 2) * q.w);
  }
  /// Its slope.
  Row jacobian(const Body& body1, const Body& body2) const {
    const quat q = rotation(body1, body2);
    const vec3 v(q.x, q.y, q.z), a = angle.a1_local;
    const vec3 g = std::cos(at / 2) * (q.w * a + cross(v, a)) + std::sin(at / 2) * v;
    const vec3 world = to_world(body1, sign * g);
    return {vec3(0), -world, vec3(0), world};
  }
  /// Chooses the sign for a step. \return true if it has changed: the swing has passed half a turn
  bool choose_sign(const Body& body1, const Body& body2) {
    const quat q = rotation(body1, body2);
    const real cosine = std::cos(at / 2) * q.w + std::sin(at / 2) * along_axis(q);
    return std::exchange(sign, cosine < 0 ? real(-1) : real(1)) != sign;
  }

 private:
  quat rotation(const Body& body1, const Body& body2) const {
    return conjugate(body1.q) * body2.q * conjugate(angle.start);
  }
  real along_axis(const quat& q) const { return dot(vec3(q.x, q.y, q.z), angle.a1_local); }
};

/// A component of the swing that is held at zero while the twist is free, exact at every swing:
/// C = (a1 x a2).n1 [1], about the component [rad] where the swing is small; J = (0, -g^T, 0, g^T)
/// with g = a2 x (n1 x a1), and |g| = 1 where C = 0; K = g.(I1^-1 + I2^-1) g [1/(kg m^2)].
struct HeldSwing {
  SwingAngle angle;  ///< the component

  static constexpr int rows = 1;               ///< one row
  static constexpr bool one_sided = false;     ///< it acts in both directions
  static constexpr Form form = Form::angular;  ///< the form of its row
  /// C [1].
  real error(const Body& body1, const Body& body2) const {
    return dot(to_world(body2, angle.a2_local), across(body1));
  }
  /// Its slope.
  Row jacobian(const Body& body1, const Body& body2) const {
    const vec3 g = cross(to_world(body2, angle.a2_local), across(body1));
    return {vec3(0), -g, vec3(0), g};
  }

 private:
  vec3 across(const Body& body1) const {
    return to_world(body1, cross(angle.n1_local, angle.a1_local));
  }
};

/// An angle whose rate changes within a step because the bodies also rotate about other axes. Its
/// limits have rows for the end of the step, too; equal limits have a row that is exact everywhere
/// (HeldAngle, HeldSwing), except for a component of the swing that is held elsewhere than at zero.
template <class Coordinate>
class TurnedCoordinate : public FreeCoordinate<Coordinate> {
  using Free = FreeCoordinate<Coordinate>;

 public:
  using Free::Free;
  /// The torque of the limits in the last step [N m].
  real limit_force() const { return Free::limit_force() + Free::force(end_.sum()); }
  /// Tells a component of the swing the twist of its joint, which lives as long.
  void set_twist(const TurnedCoordinate<HingeAngle>& twist) { twist_ = &twist; }
  /// True if equal limits hold it. \param at where, or near [rad]
  bool held(real at) const { return Free::limits().lower == at && Free::limits().upper == at; }

 protected:
  template <class, class...>
  friend class WithCoordinates;

  /// Chooses the rows of a step. \param h step [s]
  void choose(const Bodies& bodies, real h) {
    end_.clear();
    Free::choose(bodies, h);
    row_ = std::monostate();
    const real at = Free::limits().lower;
    if (!held(at) || !Free::limited_now()) return;
    if constexpr (std::is_same_v<Coordinate, HingeAngle>) {
      row_ = HeldAngle{Free::coordinate(), at, sign_};
    } else if constexpr (std::is_same_v<Coordinate, SwingAngle>) {
      const SwingAngle& swing = Free::coordinate();
      if (at == 0 && twist_ && twist_->held(0))
        row_ = HeldAngle{{swing.n1_local, twist_->coordinate().start}, 0, sign_};
      else if (at == 0)
        row_ = HeldSwing{swing};
    }
    if (HeldAngle* const angle = std::get_if<HeldAngle>(&row_)) {
      const Joint& joint = Free::joint();
      if (angle->choose_sign(bodies[joint.body1], bodies[joint.body2])) Free::limit_impulse() = 0;
      sign_ = angle->sign;
    }
  }
  /// Appends the row of a limit, or of an angle that is held.
  void append_limit(const Bodies& bodies, Blocks& blocks) const {
    if (const HeldAngle* const angle = std::get_if<HeldAngle>(&row_))
      Free::append(bodies, blocks, *angle, Free::limit_target(), Free::limit_impulse());
    else if (const HeldSwing* const swing = std::get_if<HeldSwing>(&row_))
      Free::append(bodies, blocks, *swing, Free::limit_target(), Free::limit_impulse());
    else
      Free::append_limit(bodies, blocks);
  }
  /// Adds the rows of limits that hold at the end of the step. \param h step [s]
  void late(const Bodies& bodies, real h, Blocks& blocks) {
    Free::late(bodies, h, blocks);
    const auto [lower, upper] = Free::limits();
    const Joint& joint = Free::joint();
    for (const real sign : {real(1), real(-1)})
      if (lower < upper && std::abs(sign > 0 ? lower : upper) < unbounded)
        end_.append(Free::limit(sign), bodies, joint.body1, joint.body2, h, Free::limit_target(),
                    blocks, sign);
  }
  /// Sets all impulses to zero: both bodies are static.
  void drop() {
    end_.clear();
    Free::drop();
  }
  /// Saves or restores what a step hands on to the next.
  void serialize(StateStream& stream) {
    Free::serialize(stream);
    end_.serialize(stream);
    stream(sign_);
  }

 private:
  EndRows end_;
  std::variant<std::monostate, HeldAngle, HeldSwing> row_;  // of equal limits, in this step
  real sign_ = 1;                                           // of a HeldAngle
  const TurnedCoordinate<HingeAngle>* twist_ = nullptr;     // of the same joint
};

}  // namespace joints
/// @}
