// A joint with one free coordinate that may have limits and a motor: what hinge and slider share.
// Given, there is nothing to edit here.
#pragma once

#include <algorithm>

#include "chapters/03_hinge/hinge.h"
#include "engine/composite.h"
#include "engine/joint.h"

/// \addtogroup chapter3
/// @{
namespace joints {

/// One limit of a coordinate as a part: C = sign (x - bound) >= 0.
template <class Coordinate>
struct Limit {
  Coordinate coordinate;  ///< the part whose error is x
  real bound = 0;         ///< the value of x at the limit [rad or m]
  real sign = 1;          ///< +1 for a lower limit, -1 for an upper one

  static constexpr int rows = 1;           ///< one
  static constexpr bool one_sided = true;  ///< it only pushes C up
  /// C, the gap to the limit [rad or m]; negative beyond it.
  real error(const Body& body1, const Body& body2) const {
    return sign * (coordinate.error(body1, body2) - bound);
  }
  /// The coordinate's row with the limit's sign.
  Row jacobian(const Body& body1, const Body& body2) const {
    const Row J = coordinate.jacobian(body1, body2);
    return {sign * J.v1, sign * J.w1, sign * J.v2, sign * J.w2};
  }
};

/// The farthest limit of a coordinate [rad or m].
constexpr real max_limit = real(1e9);

/// Tells an angle to count its turns to within half a turn of `expected`. A length has no turns.
template <class Coordinate>
void count_from(Coordinate&, [[maybe_unused]] real expected) {}

/// Says when a step need not measure the coordinate, because its limits are out of reach. This
/// general one never skips; hinge_joint.h has the one that skips the hinge's atan2.
template <class Coordinate>
struct Leeway {
  /// Called after each measurement. \param slack to the nearer limit [rad or m]
  void measured(const Coordinate&, const Body&, const Body&, [[maybe_unused]] real slack) {}
  void forget() {}  ///< the next step measures in any case
  /// True if the rotation since the measurement cannot have used up half of the slack.
  bool still_near(const Coordinate&, const Body&, const Body&) const { return false; }
  /// True if this step at the present velocities cannot use up half of the slack. \param h step [s]
  bool is_slow(const Body&, const Body&, [[maybe_unused]] real h) const { return false; }
};

/// Two rigid parts, and the part whose error is the coordinate that they leave free.
/// The order of its blocks is motor, limit, rigid rows: what is solved last is most nearly true.
/// With `whole` the rigid rows are one block, and the limit is that block's last row.
template <class First, class Second, class Coordinate>
class DrivenJoint : public Joint {
 public:
  First first;            ///< a rigid part
  Second second;          ///< the other rigid part
  Coordinate coordinate;  ///< the angle [rad] or displacement [m] that stays free
  bool whole = true;      ///< one block for all rigid rows and the limit, not one for each part

  /// Limits of the coordinate [rad or m]; equal ones hold it there, infinite ones are none.
  /// \throws std::invalid_argument unless lower <= upper and both are infinite or within max_limit
  void set_limits(real lower, real upper) {
    require(lower <= upper && lower < unbounded && upper > -unbounded,
            "lower: must not be above upper, and neither infinite on its wrong side [rad or m]");
    for (const real bound : {lower, upper})
      require(std::abs(bound) <= max_limit || std::abs(bound) == unbounded,
              bound == lower ? "lower" : "upper", bound,
              "must be within 1e9 [rad or m]; infinite for no limit");
    range_ = {lower, upper};
    leeway_.forget();
  }
  /// Removes both limits.
  void clear_limits() { range_ = {}, leeway_.forget(); }
  /// Runs the motor. \param speed [rad/s or m/s] \param strength [N m or N], 0 to switch it off
  /// \throws std::invalid_argument unless the speed is within max_speed and the strength at least 0
  void set_motor(real speed, real strength) {
    require(std::abs(speed) <= max_speed, "speed", speed, "must be within 3e8 [rad/s or m/s]");
    require(strength >= 0, "strength", strength, "must not be negative [N m or N]");
    motor_ = {speed, strength};
    leeway_.forget();
  }
  const Range& limits() const { return range_; }  ///< the limits of the coordinate
  const Motor& motor() const { return motor_; }   ///< the motor's settings

  /// The coordinate [rad or m]. Turns are counted while the joint has a limit or a running motor.
  real position(const Bodies& bodies) const {
    Coordinate now = coordinate;
    count_from(now, expected());
    return now.error(bodies[body1], bodies[body2]);
  }
  /// Its rate [rad/s or m/s].
  real speed(const Bodies& bodies) const {
    const Body &a = bodies[body1], &b = bodies[body2];
    return row_velocity(coordinate.jacobian(a, b), a, b);
  }
  real motor_force() const { return mean_force(impulse_[motor_place]); }  ///< last step [N m or N]
  /// The limits' force in the last step [N m or N]; positive pushes the coordinate up.
  real limit_force() const {
    return mean_force(limit_.sign * impulse_[limit_place] + late_.sign * impulse_[late_place]);
  }
  /// The forces of the rigid rows in the last step [N or N m], first part, then second.
  Vector<First::rows + Second::rows> forces() const {
    Vector<First::rows + Second::rows> out;
    for (int i = 0; i < limit_place; ++i) out[i] = mean_force(impulse_[i]);
    return out;
  }

  /// The bodies, beta, and the three parts by their check().
  void check_input(const Bodies& bodies) const override {
    Joint::check_input(bodies);
    check(first);
    check(second);
    check(coordinate);
  }
  /// Measures again, so that no turn is lost, if projection has moved the bodies too far.
  void moved(const Bodies& bodies) override;
  /// Appends motor, limit and rigid rows, as far as they are live.
  void append(const Bodies& bodies, Blocks& blocks) const override;
  /// Appends a limit that the new velocities would pass within this step.
  void late_limits(const Bodies& bodies, real h, Blocks& blocks) override;
  int most_rows() const override { return places; }  ///< rigid rows, limit, motor, late limit
  /// A limit if there are bounds, a motor if it has strength.
  Extras extras() const override {
    return {limited() ? 1 : 0, limit_.live || late_.live ? 1 : 0, motor_.strength > 0 ? 1 : 0};
  }

 protected:
  /// Counts turns, and chooses the limit that has a row in this step.
  void choose_rows(const Bodies& bodies, real h) override;
  void drop_rows() override { limit_ = late_ = {}, impulse_ = {}; }  ///< between static bodies
  /// From the parts as they stand now.
  DrivenJoint(BodyId body1, BodyId body2, const First& first, const Second& second,
              const Coordinate& coordinate)
      : Joint(body1, body2), first(first), second(second), coordinate(coordinate) {}

 private:
  // Indices of the impulses: rigid rows, the limit right behind them, motor, late limit.
  static constexpr int limit_place = First::rows + Second::rows;
  static constexpr int motor_place = limit_place + 1, late_place = limit_place + 2;
  static constexpr int places = limit_place + 3;

  // After an overflow turns are counted anew.
  real expected() const { return finite(next_) ? next_ : real(0); }
  // With a limit or a motor the coordinate and its turns are measured.
  bool counted() const { return limited() || motor_.strength > 0; }
  void measure(const Bodies& bodies) {
    count_from(coordinate, expected());
    next_ = x_ = coordinate.error(bodies[body1], bodies[body2]);
    measured_ = true;
  }
  real slack() const { return std::min(x_ - range_.lower, range_.upper - x_); }
  bool limited() const { return range_.lower > -unbounded || range_.upper < unbounded; }
  bool held() const { return range_.lower == range_.upper; }
  Limit<Coordinate> limit_part(real sign) const {
    return {coordinate, sign > 0 ? range_.lower : range_.upper, sign};
  }
  RowTarget limit_target() const { return {.beta = beta, .lower = held() ? -unbounded : real(0)}; }

  Range range_;
  Motor motor_;
  LimitRow limit_, late_;  // the limit that has a row in this step; one found late
  real x_ = 0, next_ = 0;  // the coordinate when measured; its expected value after the step
  bool measured_ = false;  // x_ was measured in this step
  Leeway<Coordinate> leeway_;
  mutable Vector<places> impulse_{};  // written by the solver through the blocks
};

template <class First, class Second, class Coordinate>
void DrivenJoint<First, Second, Coordinate>::choose_rows(const Bodies& bodies, real h) {
  const LimitRow before = limit_;
  limit_ = late_ = {};
  const Body &a = bodies[body1], &b = bodies[body2];
  measured_ = false;
  if (counted() && !(leeway_.is_slow(a, b, h) && leeway_.still_near(coordinate, a, b))) {
    measure(bodies);
    leeway_.measured(coordinate, a, b, slack());
    if (limited()) limit_ = limit_row(range_, x_, speed(bodies), h);
  }
  if (!limit_.live || !before.live || limit_.sign != before.sign) impulse_[limit_place] = 0;
  if (motor_.strength == 0) impulse_[motor_place] = 0;
  impulse_[late_place] = 0;
}

template <class First, class Second, class Coordinate>
void DrivenJoint<First, Second, Coordinate>::moved(const Bodies& bodies) {
  if (!counted() || leeway_.still_near(coordinate, bodies[body1], bodies[body2])) return;
  measure(bodies);
  leeway_.forget();
}

template <class First, class Second, class Coordinate>
void DrivenJoint<First, Second, Coordinate>::append(const Bodies& bodies, Blocks& blocks) const {
  const auto add = [&](const auto& part, const RowTarget& target, int place) {
    blocks.append(bodies, body1, body2, part, target, &impulse_[place]);
  };
  if (motor_.strength > 0)
    add(coordinate,
        {.rate = motor_.speed,
         .holds_position = false,
         .lower = -motor_.strength,
         .upper = motor_.strength},
        motor_place);
  const Limit<Coordinate> limit = limit_part(limit_.sign);
  const Composite<First, Second> rigid{first, second};
  if (!whole) {
    if (limit_.live) add(limit, limit_target(), limit_place);
    add(first, {.beta = beta}, 0);
    add(second, {.beta = beta}, First::rows);
  } else if (limit_.live) {
    add(Composite<Composite<First, Second>, Limit<Coordinate>>{rigid, limit}, limit_target(), 0);
  } else {
    add(rigid, {.beta = beta}, 0);
  }
  if (late_.live) add(limit_part(late_.sign), limit_target(), late_place);
}

// A neighbour's impulse may drive the joint past a limit that had no row at the step's beginning.
template <class First, class Second, class Coordinate>
void DrivenJoint<First, Second, Coordinate>::late_limits(const Bodies& bodies, real h,
                                                         Blocks& blocks) {
  if (!counted()) return;
  if (leeway_.is_slow(bodies[body1], bodies[body2], h)) return;
  leeway_.forget();
  if (!measured_) measure(bodies);
  const real rate = speed(bodies);
  next_ = x_ + h * std::clamp(rate, -max_speed, max_speed);  // as fast as bodies can be
  if (!limited() || held() || late_.live) return;
  for (const real sign : {real(1), real(-1)}) {
    const real C = sign * (x_ - limit_part(sign).bound);
    if (C + h * sign * rate >= 0 || (limit_.live && limit_.sign == sign)) continue;
    late_ = {C, sign, true};
    blocks.append(bodies, body1, body2, limit_part(sign), limit_target(), &impulse_[late_place]);
    return;
  }
}

}  // namespace joints
/// @}
