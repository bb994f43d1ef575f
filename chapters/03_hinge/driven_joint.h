// A joint with one free coordinate that may have limits and a motor: the common base of hinge and
// slider. Given: there is nothing to edit here.
#pragma once

#include <algorithm>
#include <memory>
#include <numbers>

#include "chapters/03_hinge/free_coordinate.h"
#include "engine/composite.h"

/// \addtogroup chapter3
/// @{
namespace joints {

/// Two rigid parts, and a part whose error is the free coordinate.
/// Its blocks are in the order motor, limit, rigid rows, because the block that is solved last is
/// satisfied best. With `whole` the rigid rows are one block, and the limit is its last row.
template <class First, class Second, class Coordinate>
class DrivenJoint : public Joint {
 public:
  First first;        ///< a rigid part
  Second second;      ///< the other rigid part
  bool whole = true;  ///< one block for all rigid rows and the limit; false: one for each part

  /// The free coordinate, an angle [rad] or a displacement [m].
  const Coordinate& coordinate() const { return coordinate_; }
  /// Replaces the free coordinate. \throws std::invalid_argument from its check()
  void set_coordinate(const Coordinate& coordinate) {
    check(coordinate);
    coordinate_ = coordinate;
    if (drive_) drive_->leeway.forget();
  }

  /// Sets the limits of the coordinate [rad or m]. Equal limits hold it at that value, and infinite
  /// ones have no effect. If the joint has not counted turns so far, limits less than a turn apart
  /// determine the turn: the one in which the angle is between them or nearest to them. With wider
  /// limits the turn is ambiguous; call expect() to choose it.
  /// \throws std::invalid_argument unless lower <= upper and both are infinite or within max_limit
  void set_limits(real lower, real upper) {
    check(Range{lower, upper});
    drive().range = {lower, upper};
  }
  /// Removes both limits.
  void clear_limits() {
    if (drive_) drive().range = {};
  }
  /// Sets the motor. \param speed target [rad/s or m/s] \param strength [N m or N], 0 for no motor
  /// \throws std::invalid_argument unless the speed is within max_speed and the strength at least 0
  void set_motor(real speed, real strength) {
    check(Motor{speed, strength});
    drive().motor = {speed, strength};
  }
  /// Dry friction: a motor with the target speed 0 and at most this torque or force. It replaces
  /// the motor, and set_motor() replaces it: a joint has only one of the two.
  /// \param strength [N m or N], 0 for none \throws std::invalid_argument if it is negative
  void set_friction(real strength) { set_motor(0, strength); }
  /// Sets the value of the coordinate to within half a turn, from which turns are counted. Use it
  /// for bodies that were placed or loaded more than half a turn from zero, or to reset the count.
  /// \param x [rad or m] \throws std::invalid_argument unless it is finite
  void expect(real x) {
    require(finite(x), "x: must be finite [rad or m]");
    drive().next = x;
    drive().counting = true;
  }
  /// The limits of the coordinate.
  Range limits() const { return drive_ ? drive_->range : Range{}; }
  /// The motor's settings.
  Motor motor() const { return drive_ ? drive_->motor : Motor{}; }

  /// The coordinate [rad or m]. Turns are counted only while the joint has a limit or a motor with
  /// a strength above 0; see expect().
  real position(const Bodies& bodies) const {
    Coordinate now = coordinate_;
    count_from(now, expected(bodies));
    return now.error(bodies[body1], bodies[body2]);
  }
  /// The rate of the coordinate [rad/s or m/s]. With Stepping::leapfrog it lags by half a step;
  /// synchronised() in step.h returns bodies without this lag.
  real speed(const Bodies& bodies) const {
    const Body &a = bodies[body1], &b = bodies[body2];
    return row_velocity(coordinate_.jacobian(a, b), a, b);
  }
  /// The torque or force of the motor in the last step [N m or N].
  real motor_force() const { return drive_ ? mean_force(drive_->motor_impulse) : real(0); }
  /// The torque or force of the limits in the last step [N m or N]. A positive one increases the
  /// coordinate.
  real limit_force() const {
    if (!drive_) return 0;
    return mean_force(drive_->limit.sign * impulse_[limit_place] +
                      drive_->late.sign * drive_->late_impulse);
  }
  /// The forces of the rigid rows in the last step [N or N m], first part, then second.
  Vector<First::rows + Second::rows> forces() const {
    Vector<First::rows + Second::rows> out;
    for (int i = 0; i < limit_place; ++i) out[i] = mean_force(impulse_[i]);
    return out;
  }

  /// Validates the bodies, beta, and the two rigid parts by their check().
  void check_input(const Bodies& bodies) const override {
    Joint::check_input(bodies);
    check(first);
    check(second);
  }
  /// Measures again if projection has moved the bodies so far that a turn could be missed.
  void moved(const Bodies& bodies) override;
  /// Appends the blocks of motor, limit and rigid rows that are live.
  void append(const Bodies& bodies, Blocks& blocks) const override;
  /// Appends a limit that the new velocities would pass within this step.
  void late_limits(const Bodies& bodies, real h, Blocks& blocks) override {
    if (!drive_ || drive_->off) return;
    if (!drive_->leeway.is_slow(at(bodies, body1), at(bodies, body2), h))
      add_late_limit(bodies, h, blocks);
  }
  /// Reports a limit if one is set, and a motor if its strength is above 0.
  Extras extras() const override {
    if (!drive_) return {};
    return {drive_->limited() ? 1 : 0, drive_->limit.live || drive_->late.live ? 1 : 0,
            drive_->motor.strength > 0 ? 1 : 0};
  }

 protected:
  /// Counts turns, and chooses the limit that has a row in this step.
  void choose_rows(const Bodies& bodies, real h) override {
    if (!drive_ || drive_->off) return;
    const Body &a = at(bodies, body1), &b = at(bodies, body2);
    const bool near = drive_->leeway.is_slow(a, b, h) && drive_->leeway.still_near(a, b);
    if (!near || drive_->measured) choose_limit(bodies, h, near);
  }
  /// Clears all impulses; called if both bodies are static.
  void drop_rows() override {
    impulse_ = {};
    if (drive_) drive_->drop();
  }
  /// Saves or restores limits, motor, count, live rows and impulses. The number of values does not
  /// depend on whether there are limits or a motor.
  void exchange_own(StateStream& stream) override {
    Drive none;
    Drive& drive = drive_ ? *drive_ : none;
    stream.bound(drive.range.lower), stream.bound(drive.range.upper);
    stream.bound(drive.motor.strength);
    stream(drive.motor.speed, drive.x, drive.next, drive.estimated, drive.counting, drive.measured,
           drive.motor_impulse, drive.late_impulse, impulse_);
    for (LimitRow* row : {&drive.limit, &drive.late}) {
      stream(row->sign, row->live);
      require(std::abs(row->sign) == 1, "state: the sign of a limit's row must be 1 or -1");
    }
    check(drive.range), check(drive.motor);
    exchange_turns(coordinate_, stream);
    drive.leeway.exchange(stream);
    drive.off = false;  // limits and motor may be others now
    if (none.counted() || none.counting) drive_ = std::make_unique<Drive>(none);
  }
  /// Makes the joint from its parts.
  DrivenJoint(BodyId body1, BodyId body2, const First& first, const Second& second,
              const Coordinate& coordinate)
      : Joint(body1, body2), first(first), second(second), coordinate_(coordinate) {}

 private:
  // The data of a joint with a limit or a motor; a joint without them has none.
  struct Drive {
    Range range;
    Motor motor;
    LimitRow limit, late;   // the limit with a row in this step; the one found late
    real x = 0, next = 0;   // the coordinate at the step's begin; its expected value after it
    real estimated = 0;     // change of x since it was measured, by the rate alone
    bool measured = false;  // x was measured in this step
    bool counting = false;  // next is valid: measured, or set by expect()
    bool off = false;       // neither limit nor motor: nothing to do until a setting changes
    Leeway<Coordinate> leeway;
    real motor_impulse = 0, late_impulse = 0;  // written by the solver through the blocks

    // True if the coordinate and its turns are measured.
    bool counted() const { return limited() || motor.strength > 0; }
    bool limited() const { return range.lower > -unbounded || range.upper < unbounded; }
    // True if only the count of turns needs x: then the last rate is exact enough for 2 rad.
    bool can_estimate() const { return !limited() && counting && next != x && estimated < 2; }
    bool held() const { return range.lower == range.upper; }
    real slack() const { return std::min(x - range.lower, range.upper - x); }
    real bound(real sign) const { return sign > 0 ? range.lower : range.upper; }
    void drop() { limit = late = {}, motor_impulse = late_impulse = 0; }
  };
  // Access for a change of settings: makes the next step measure.
  Drive& drive() {
    if (!drive_) drive_ = std::make_unique<Drive>();
    drive_->leeway.forget();
    drive_->off = false;
    return *drive_;
  }

  static constexpr int limit_place = First::rows + Second::rows;  // after the rigid rows

  // Unchecked access: the step has validated the ids.
  static const Body& at(const Bodies& bodies, BodyId id) { return bodies.at(int(id.slot)); }
  // Rarely needed, so not inlined.
  [[gnu::noinline]] void choose_limit(const Bodies& bodies, real h, bool near);
  [[gnu::noinline]] void add_late_limit(const Bodies& bodies, real h, Blocks& blocks);
  // The coordinate is within half a turn of this value. If the joint does not count turns yet, the
  // limits determine the turn.
  real expected(const Bodies& bodies) const {
    if (!drive_) return 0;
    const auto& [lower, upper] = drive_->range;
    const real next = finite(drive_->next) ? drive_->next : real(0);  // 0 after an overflow
    if (drive_->counting || !(upper - lower < 2 * std::numbers::pi_v<real>)) return next;
    Coordinate now = coordinate_;
    count_from(now, next);
    const real x = now.error(bodies[body1], bodies[body2]);
    return lower <= x && x <= upper ? next : (lower + upper) / 2;
  }
  void measure(const Bodies& bodies) {
    count_from(coordinate_, expected(bodies));
    drive_->next = drive_->x = coordinate_.error(bodies[body1], bodies[body2]);
    drive_->estimated = 0;
    drive_->measured = drive_->counting = true;
  }
  Limit<Coordinate> limit_part(real sign) const {
    return {coordinate_, drive_->bound(sign), sign};
  }
  RowTarget limit_target() const { return hold(drive_->held() ? -unbounded : real(0)); }

  Coordinate coordinate_;
  std::unique_ptr<Drive> drive_;
  mutable Vector<limit_place + 1> impulse_{};  // written by the solver through the blocks
};

template <class First, class Second, class Coordinate>
void DrivenJoint<First, Second, Coordinate>::choose_limit(const Bodies& bodies, real h,
                                                          bool near) {
  Drive& drive = *drive_;
  const Body &a = at(bodies, body1), &b = at(bodies, body2);
  const LimitRow before = drive.limit;
  drive.measured = false;
  drive.limit = drive.late = {};
  drive.off = !drive.counted();
  if (drive.off) drive.counting = false;
  if (drive.counted() && drive.can_estimate()) {
    drive.estimated += std::abs(drive.next - drive.x);
    drive.x = drive.next;
  } else if (drive.counted() && !near) {
    measure(bodies);
    drive.leeway.measured(coordinate_, a, b, drive.slack());
    if (drive.limited()) drive.limit = limit_row(drive.range, drive.x, speed(bodies), h);
  }
  if (!drive.limit.live || drive.limit.sign != before.sign) impulse_[limit_place] = 0;
  if (drive.motor.strength == 0) drive.motor_impulse = 0;
  drive.late_impulse = 0;
}

template <class First, class Second, class Coordinate>
void DrivenJoint<First, Second, Coordinate>::moved(const Bodies& bodies) {
  if (!drive_ || !drive_->counted() || drive_->leeway.still_near(bodies[body1], bodies[body2]))
    return;
  measure(bodies);
  drive_->leeway.forget();
}

template <class First, class Second, class Coordinate>
void DrivenJoint<First, Second, Coordinate>::append(const Bodies& bodies, Blocks& blocks) const {
  const auto add = [&](const auto& part, const RowTarget& target, real& impulse) {
    blocks.append(bodies, body1, body2, part, target, &impulse);
  };
  const bool limited = drive_ && drive_->limit.live;
  if (drive_ && drive_->motor.strength > 0)
    add(coordinate_,
        {.rate = drive_->motor.speed,
         .holds_position = false,
         .lower = -drive_->motor.strength,
         .upper = drive_->motor.strength},
        drive_->motor_impulse);
  if (!whole) {
    if (limited) add(limit_part(drive_->limit.sign), limit_target(), impulse_[limit_place]);
    add(first, hold(), impulse_[0]);
    add(second, hold(), impulse_[First::rows]);
  } else if (limited) {
    add(Composite<Composite<First, Second>, Limit<Coordinate>>{{first, second},
                                                               limit_part(drive_->limit.sign)},
        limit_target(), impulse_[0]);
  } else {
    add(Composite<First, Second>{first, second}, hold(), impulse_[0]);
  }
  if (drive_ && drive_->late.live)
    add(limit_part(drive_->late.sign), limit_target(), drive_->late_impulse);
}

// A neighbour's impulse may drive the joint past a limit that had no row at the start of the step.
template <class First, class Second, class Coordinate>
void DrivenJoint<First, Second, Coordinate>::add_late_limit(const Bodies& bodies, real h,
                                                            Blocks& blocks) {
  Drive& drive = *drive_;
  drive.leeway.forget();
  if (!drive.measured && drive.limited()) measure(bodies);
  const real rate = speed(bodies);
  drive.next = drive.x + h * std::clamp(rate, -max_speed, max_speed);  // bodies are clamped, too
  if (!drive.limited() || drive.held() || drive.late.live) return;
  for (const real sign : {real(1), real(-1)}) {
    const real C = sign * (drive.x - drive.bound(sign));
    if (C + h * sign * rate >= 0 || (drive.limit.live && drive.limit.sign == sign)) continue;
    drive.late = {C, sign, true};
    blocks.append(bodies, body1, body2, limit_part(sign), limit_target(), &drive.late_impulse);
    return;
  }
}

}  // namespace joints
/// @}
