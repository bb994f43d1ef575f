// The free coordinate of a joint: an angle or a displacement, and all that acts on it. Given: there
// is nothing to edit here.
#pragma once

#include <array>
#include <memory>
#include <utility>

#include "engine/parts/part.h"
#include "joints/limits_and_springs.h"

/// \addtogroup chapter3
/// @{
namespace joints {

/// One free coordinate x of a joint, an angle [rad] or a displacement [m], and all that acts on it:
/// limits, a motor or a servo, friction, a spring. Each has a row of its own while it acts. A joint
/// may have any number of coordinates: it calls choose() when a step begins, append_drives() and
/// append_limit() for the blocks, and late() after each solve. Turns are counted from step to step
/// while something acts: x is expected to be x + h dx/dt at the end of a step.
template <class Coordinate>
class FreeCoordinate {
  static_assert(require_part<Coordinate>() && Coordinate::rows == 1, "a coordinate has one row");
  static_assert(Checked<Coordinate>, "this coordinate needs a free function `check(const C&)`");

 public:
  /// One of a joint. \param joint the joint \param coordinate the part whose error is x
  FreeCoordinate(const Joint& joint, const Coordinate& coordinate)
      : joint_(joint), coordinate_(coordinate) {}

  /// The part whose error is x and whose jacobian is the row of everything that acts on x.
  const Coordinate& coordinate() const { return coordinate_; }
  /// Replaces that part. \throws std::invalid_argument from its check()
  void set_coordinate(const Coordinate& coordinate) {
    check(coordinate);
    coordinate_ = coordinate;
    if (data_) data_->leeway.forget();
  }

  /// Sets the limits of the coordinate [rad or m]. Equal limits hold it at that value, and infinite
  /// ones have no effect. If the joint has not counted turns so far, limits less than a turn apart
  /// determine the turn: the one in which the angle is between them or nearest to them. With wider
  /// limits the turn is ambiguous; call expect() to choose it.
  /// \throws std::invalid_argument unless lower <= upper and both are infinite or within max_limit
  void set_limits(real lower, real upper) {
    check(Range{lower, upper});
    change().range = {lower, upper};
  }
  /// Removes both limits.
  void clear_limits() {
    if (data_) change().range = {};
  }
  /// Sets the motor; it replaces a servo. \param speed target [rad/s or m/s]
  /// \param strength [N m or N], 0 for no motor
  /// \throws std::invalid_argument unless the speed is within max_speed and the strength at least 0
  void set_motor(real speed, real strength) {
    check(Motor{speed, strength});
    Data& data = change();
    data.motor = {speed, strength};
    data.target = unbounded;
  }
  /// A position drive with a bounded speed: a motor that removes the fraction Joint::beta of the
  /// remaining displacement in each step. It replaces the motor; for a drive with a stiffness set a
  /// spring with a strength. \param target value of x [rad or m] \param speed greatest speed, not
  /// negative [rad/s or m/s] \param strength [N m or N], 0 for no servo
  /// \throws std::invalid_argument for a target beyond max_limit, or as set_motor()
  void set_servo(real target, real speed, real strength) {
    require(std::abs(target) <= max_limit, "target", target, "must be within 1e9 [rad or m]");
    require(speed >= 0, "speed", speed, "of a servo must not be negative [rad/s or m/s]");
    set_motor(speed, strength);
    data_->target = target;
  }
  /// Dry friction, beside the motor if there is one: it opposes the motion with this torque or
  /// force and holds the coordinate at rest if that suffices.
  /// \param strength [N m or N], 0 for none \throws std::invalid_argument if it is negative
  void set_friction(real strength) {
    check(Motor{0, strength});
    change().friction = strength;
  }
  /// Sets the spring; one without stiffness and damping removes it. With a strength it is a
  /// position drive. \throws std::invalid_argument as check(const Spring&)
  void set_spring(const Spring& spring) {
    check(spring);
    change().spring = spring;
  }
  /// Sets the value of the coordinate to within half a turn, from which turns are counted. Use it
  /// for bodies that were placed or loaded more than half a turn from zero, or to reset the count.
  /// \param x [rad or m] \throws std::invalid_argument unless it is finite
  void expect(real x) {
    require(finite(x), "x: must be finite [rad or m]");
    Data& data = change();
    data.next = x;
    data.known = Known::turn;
  }
  /// For a way to move bodies that appends no rows: the coordinate at the end of a step.
  /// \param x [rad or m] \param impulses of motor, friction, limits and spring [N m s or N s]
  void tell(real x, const std::array<real, 4>& impulses) {
    expect(x);
    Rows& now = data_->now = {};
    now.motor_impulse = impulses[0], now.friction_impulse = impulses[1];
    now.spring_impulse = impulses[3];
    now.limit_sign = impulses[2] == 0 ? real(0) : std::copysign(real(1), impulses[2]);
    limit_impulse() = std::abs(impulses[2]);
  }
  Range limits() const { return data_ ? data_->range : Range{}; }     ///< the limits
  Motor motor() const { return data_ ? data_->motor : Motor{}; }      ///< the motor or servo
  /// The target of a servo [rad or m]; infinite for a motor.
  real target() const { return data_ ? data_->target : unbounded; }
  /// True if the coordinate has limits, a motor or servo, friction or a spring.
  bool acts() const { return data_ && (data_->limited() || data_->pushes()); }
  real friction() const { return data_ ? data_->friction : 0; }       ///< its strength [N m or N]
  Spring spring() const { return data_ ? data_->spring : Spring{}; }  ///< the spring

  /// The coordinate [rad or m]. Turns are counted only while something acts on it; see expect().
  real position(const Bodies& bodies) const {
    Coordinate now = coordinate_;
    if constexpr (requires { now.expected; }) now.expected = expected();
    return now.error(bodies[joint_.body1], bodies[joint_.body2]);
  }
  /// The rate of the coordinate [rad/s or m/s]. With StepOptions::leapfrog it lags by half a step;
  /// velocities_at_pose_time() in step.h returns bodies without this lag.
  real speed(const Bodies& bodies) const {
    const Body &a = bodies[joint_.body1], &b = bodies[joint_.body2];
    return row_velocity(coordinate_.jacobian(a, b), a, b);
  }
  /// The torque or force of the motor or servo in the last step [N m or N]. Positive ones increase
  /// the coordinate, here and below.
  real motor_force() const { return data_ ? force(data_->now.motor_impulse, data_->now.shift) : 0; }
  /// The torque or force of the friction in the last step [N m or N].
  real friction_force() const {
    return data_ ? force(data_->now.friction_impulse, -data_->now.shift) : 0;
  }
  /// The torque or force of the spring in the last step [N m or N].
  real spring_force() const { return data_ ? force(data_->now.spring_impulse) : 0; }
  /// The torque or force of the limits in the last step [N m or N].
  real limit_force() const {
    if (!data_) return 0;
    const Rows& now = data_->now;
    return force(now.limit_sign * limit_impulse() + now.late_sign * now.late_impulse);
  }

 protected:
  template <class, class...>
  friend class WithCoordinates;

  /// Where the impulse of the limit is, if its row belongs to a block of the joint.
  void keep_limit_impulse(real& impulse) { limit_impulse_ = &impulse; }
  /// The impulse of the limit's row. Only with limits.
  real& limit_impulse() const { return limit_impulse_ ? *limit_impulse_ : data_->limit_impulse; }
  /// Appends a block of the joint's bodies.
  void append(const Bodies& bodies, Blocks& blocks, const auto& part, const RowSettings& target,
              real& impulse) const {
    blocks.append(bodies, joint_.body1, joint_.body2, part, target, &impulse);
  }
  /// The joint that it belongs to.
  const Joint& joint() const { return joint_; }
  /// Chooses the rows of a step that begins. \param h step [s]
  void choose(const Bodies& bodies, real h) {
    if (!data_ || data_->known == Known::idle) return;
    const Body &a = at(bodies, joint_.body1), &b = at(bodies, joint_.body2);
    const bool away = data_->leeway.is_slow(a, b, h) && data_->leeway.still_near(a, b);
    if (!away || data_->known == Known::value) update_active_rows(bodies, h, away);
  }
  /// Appends the rows of spring, friction and motor that act.
  void append_drives(const Bodies& bodies, Blocks& blocks) const {
    if (data_ && data_->now.pushes) append_acting(bodies, blocks);
  }
  /// True if a limit has a row since the step began.
  bool limited_now() const { return data_ && data_->now.limit_sign != 0; }
  /// That limit as a part.
  Limit<Coordinate> limit() const { return limit(data_->now.limit_sign); }
  /// The lower limit as a part, or with the sign -1 the upper one.
  Limit<Coordinate> limit(real sign) const {
    return {coordinate_, sign > 0 ? data_->range.lower : data_->range.upper, sign};
  }
  /// The target of its row.
  RowSettings limit_target() const {
    return {.beta = joint_.beta, .frequency = joint_.frequency, .damping = joint_.damping,
            .lower = data_->held() ? -unbounded : real(0), .push = joint_.push};
  }
  /// Appends its block, if it is not in another block.
  void append_limit(const Bodies& bodies, Blocks& blocks) const {
    if (limited_now()) append_row(bodies, blocks, data_->now.limit_sign, limit_impulse());
  }
  /// Appends the block of a limit that was found late.
  void append_late(const Bodies& bodies, Blocks& blocks) const {
    if (data_ && data_->now.late_sign != 0)
      append_row(bodies, blocks, data_->now.late_sign, data_->now.late_impulse);
  }
  /// Expects the coordinate at the end of the step, and appends a limit that the new velocities
  /// would pass until then: a neighbour's impulse may do so. \param h step [s]
  void late(const Bodies& bodies, real h, Blocks& blocks) {
    if (!data_ || data_->known == Known::idle) return;
    if (!data_->leeway.is_slow(at(bodies, joint_.body1), at(bodies, joint_.body2), h))
      find_late(bodies, h, blocks);
  }
  /// Measures again if projection has moved the bodies so far that a turn could be missed.
  void after_projection(const Bodies& bodies) {
    if (!data_ || !(data_->limited() || data_->pushes())) return;
    if (data_->leeway.still_near(bodies[joint_.body1], bodies[joint_.body2])) return;
    measure(bodies);
    data_->leeway.forget();
  }
  /// The mean torque or force of an impulse in the last step. \param shift is added to it
  real force(real impulse, real shift = 0) const {
    return joint_.impulse_duration() > 0 ? joint_.mean_force(impulse) + shift : real(0);
  }
  /// Sets all impulses to zero: both bodies are static.
  void drop() {
    if (data_) data_->now = {}, limit_impulse() = 0;
  }
  /// Adds the limits and the motors, friction and springs to a report.
  void report(Joint::Stats& extras) const {
    if (!data_) return;
    extras.limits += data_->limited();
    extras.live_limits += data_->now.limit_sign != 0 || data_->now.late_sign != 0;
    extras.motors += data_->pushes();
  }
  /// Saves or restores settings, count, live rows and impulses, always as many values. The impulse
  /// of a limit belongs to the joint if it is in a block of the joint.
  void serialize(StateStream& stream) {
    Data none;
    Data& data = data_ ? *data_ : none;
    Rows& now = data.now;
    for (real* bound : {&data.range.lower, &data.range.upper, &data.target, &data.motor.strength,
                        &data.friction, &data.spring.strength})
      stream.bound(*bound);
    bool turn = data.known >= Known::turn, value = data.known == Known::value;
    stream(data.motor.speed, data.spring.stiffness, data.spring.damping, data.spring.rest, turn,
           value, data.x, data.next, data.limit_impulse, now.pushes, now.limit_sign, now.late_sign,
           now.speed, now.shift, now.motor_impulse, now.friction_impulse, now.spring_impulse,
           now.late_impulse);
    data.known = value ? Known::value : turn ? Known::turn : Known::nothing;
    for (const real sign : {now.limit_sign, now.late_sign})
      require(sign * sign * sign == sign, "state: the sign of a limit's row must be 0, 1 or -1");
    check(data.range), check(data.motor), check(Motor{0, data.friction}), check(data.spring);
    if constexpr (requires { coordinate_.expected; }) stream(coordinate_.expected);
    data.leeway.serialize(stream);
    if (!data_ && (none.limited() || none.pushes() || turn)) data_ = std::make_unique<Data>(none);
  }

 private:
  // What is known of x:   by a setting   by expect()   by a step: nothing acts, limits far, else
  //   idle                -> nothing     -> turn       idle
  //   nothing, turn, value               -> turn       -> idle, -> turn, -> value
  enum class Known : char {
    idle,     // nothing, and there is nothing to do until a setting changes
    nothing,  // nothing yet: limits determine the turn
    turn,     // it is within half a turn of `next`
    value     // it was measured in this step
  };
  // The rows of a step. The impulses are written by the solver.
  struct Rows {
    bool pushes = false;                 // motor, friction or spring have one
    real limit_sign = 0, late_sign = 0;  // of a limit with a row, and of one found late; 0: none
    real speed = 0;                      // of motor or servo
    real shift = 0;                      // of the bounds of motor and friction, see append_acting()
    real motor_impulse = 0, friction_impulse = 0, spring_impulse = 0, late_impulse = 0;
  };
  // A coordinate without settings has none of these.
  struct Data {
    Range range;
    Motor motor;              // its speed is the greatest one of a servo
    real target = unbounded;  // of a servo; infinite for a motor
    real friction = 0;
    Spring spring;
    Known known = Known::nothing;
    real x = 0, next = 0;     // the coordinate when the step began; its expected value at the end
    Rows now;
    real limit_impulse = 0;   // unless it is in a block of the joint
    Leeway leeway;

    bool limited() const { return range.lower > -unbounded || range.upper < unbounded; }
    bool held() const { return range.lower == range.upper; }
    bool servo() const { return target < unbounded; }
    bool pushes() const { return motor.strength > 0 || friction > 0 || spring.acts(); }
    // How far x may move until it has to be measured.
    real slack() const {
      return servo() || spring.acts() ? 0 : std::min(x - range.lower, range.upper - x);
    }
  };
  // Access for a change of settings: makes the next step measure.
  Data& change() {
    if (!data_) data_ = std::make_unique<Data>();
    data_->leeway.forget();
    if (data_->known == Known::idle) data_->known = Known::nothing;
    return *data_;
  }

  // Unchecked access: the step has validated the ids.
  static const Body& at(const Bodies& bodies, BodyId id) { return bodies.at(int(id.slot)); }
  // The coordinate is within half a turn of this value. If the joint does not count turns yet,
  // limits less than a turn apart determine it.
  real expected() const {
    if (!data_) return 0;
    const auto& [lower, upper] = data_->range;
    if (data_->known < Known::turn && upper - lower < 2 * std::numbers::pi_v<real>)
      return (lower + upper) / 2;
    return finite(data_->next) ? data_->next : real(0);  // 0 after an overflow
  }
  void measure(const Bodies& bodies) {
    if constexpr (requires { coordinate_.expected; }) coordinate_.expected = expected();
    data_->next = data_->x = coordinate_.error(bodies[joint_.body1], bodies[joint_.body2]);
    data_->known = Known::value;
  }
  // Rarely needed, so not inlined.
  [[gnu::noinline]] void append_row(const Bodies& bodies, Blocks& blocks, real sign,
                                    real& impulse) const {
    append(bodies, blocks, limit(sign), limit_target(), impulse);
  }

  [[gnu::noinline]] void update_active_rows(const Bodies& bodies, real h, bool away) {
    Data& data = *data_;
    Rows& now = data.now;
    const real before = std::exchange(now.limit_sign, real(0));
    if (!data.limited() && !data.pushes()) {
      data.known = Known::idle;
    } else if (away) {
      data.known = Known::turn;
    } else {
      measure(bodies);
      data.leeway.measured(coordinate_, bodies[joint_.body1], bodies[joint_.body2], data.slack());
      if (data.limited()) {
        const LimitRow row = limit_row(data.range, data.x, speed(bodies), h);
        if (row.live) now.limit_sign = data.held() ? 1 : row.sign;  // held: both directions
      }
    }
    now.pushes = data.pushes();
    now.speed = data.motor.speed;
    if (data.servo())
      now.speed = std::clamp(joint_.beta / h * (data.target - data.x), -now.speed, now.speed);
    const real weaker = std::min(data.motor.strength, data.friction);
    now.shift = std::copysign(weaker, now.speed);  // Eq. 3-17
    if (now.limit_sign != before) limit_impulse() = 0;
    if (data.motor.strength == 0) now.motor_impulse = 0;
    if (data.friction == 0) now.friction_impulse = 0;
    if (!data.spring.acts()) now.spring_impulse = 0;
    now.late_sign = now.late_impulse = 0;
  }
  [[gnu::noinline]] void find_late(const Bodies& bodies, real h, Blocks& blocks) {
    Data& data = *data_;
    data.leeway.forget();
    if (data.known != Known::value && data.limited()) measure(bodies);
    const real rate = speed(bodies);
    data.next = data.x + h * std::clamp(rate, -max_speed, max_speed);  // bodies are clamped, too
    if (!data.limited() || data.held() || data.now.late_sign != 0) return;
    const real end = data.x + h * rate;
    const real sign = end < data.range.lower ? 1 : end > data.range.upper ? -1 : 0;
    if (sign != data.now.limit_sign) data.now.late_sign = sign;
    append_late(bodies, blocks);
  }

  // A motor and friction would work against each other until the weaker one is at its bound. Both
  // bounds are shifted by the weaker strength in opposite directions instead; the sum is unchanged.
  [[gnu::noinline]] void append_acting(const Bodies& bodies, Blocks& blocks) const {
    const Data& data = *data_;
    if (data.spring.acts()) {
      const Body &a = at(bodies, joint_.body1), &b = at(bodies, joint_.body2);
      const Row J = coordinate_.jacobian(a, b);
      Row response;
      real K;
      form_responses(&J, 1, a, b, &response);
      form_K(&J, &response, 1, &K);
      const auto [frequency, damping] = tuning(data.spring.stiffness, data.spring.damping, K);
      append(bodies, blocks, Limit<Coordinate>{coordinate_, data.spring.rest, 1},
             {.frequency = frequency, .damping = damping, .lower = -data.spring.strength,
              .upper = data.spring.strength},
             data_->now.spring_impulse);
    }
    const auto drive = [&](real speed, real strength, real shift, real& impulse) {
      if (strength > 0)
        append(bodies, blocks, coordinate_,
               {.rate = speed, .holds_position = false, .lower = -strength - shift,
                .upper = strength - shift},  // Eq. 3-17
               impulse);
    };
    drive(0, data.friction, -data.now.shift, data_->now.friction_impulse);
    drive(data.now.speed, data.motor.strength, data.now.shift, data_->now.motor_impulse);
  }

  const Joint& joint_;
  Coordinate coordinate_;
  real* limit_impulse_ = nullptr;
  std::unique_ptr<Data> data_;
};

}  // namespace joints
/// @}
