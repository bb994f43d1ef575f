// The interface of every joint: it makes blocks from the poses of two bodies.
#pragma once

#include <cstdint>

#include "engine/block.h"

/// \defgroup joint Joints
/// \brief The interface between engine and joints; the joints themselves are in joints/.
/// @{
namespace joints {

class StateStream;  // engine/kept

/// The largest Joint::beta [1]. Above 2 every error grows, which may be tried on purpose.
constexpr real max_beta = 10;
/// Validates a beta. \throws std::invalid_argument unless beta is from 0 to max_beta
inline void check_beta(real beta) {
  require(beta >= 0 && beta <= max_beta, "beta", beta, "must be between 0 and 10 [1]");
}

/// The base class of all joints. A step calls begin_step(), append() and, after each solve,
/// activate_missed_limits(); the solver's inner loop never calls a joint. With substeps, "step"
/// means substep. A new kind of joint is one new class in one new file; nothing else changes.
class Joint {
 public:
  BodyId body1, body2;    ///< the two bodies that it connects
  /// Fraction of the error that is removed in a step [1] (chapter 6), from 0 to max_beta.
  real beta = real(0.2);
  /// Above 0: a spring of this natural frequency [Hz] replaces beta in every row of the joint that
  /// holds a position, also in limits; position projection then leaves the joint out. 0: hard rows,
  /// unless StepOptions::frequency makes them soft. Finite and not negative, like damping.
  real frequency = 0;
  real damping = 1;       ///< damping ratio of that spring [1]; 1 is critical
  /// Greatest speed at which the velocities correct an error [m/s or rad/s]; positive. Bound it
  /// where bodies are moved by hand: joints open far then, and are closed at a high speed.
  real push = unbounded;
  bool projected = true;  ///< position projection corrects this joint (StepOptions::projections)

  /// Of two bodies. \throws std::invalid_argument for a joint of a body with itself
  Joint(BodyId body1, BodyId body2) : body1(body1), body2(body2) { require_two(); }
  virtual ~Joint() = default;
  Joint(const Joint&) = delete;  ///< a joint is not copied: auto& joint = world.add<J>(...)

  /// Validates all members that may have been changed since the last step, before every step, so it
  /// has to be fast. An override must call this one first.
  /// \throws std::invalid_argument, with member and value, for an invalid one
  virtual void check_input(const Bodies& bodies) const {
    require(bodies.alive(body1), "body1: this id names no body of this world (removed?)");
    require(bodies.alive(body2), "body2: this id names no body of this world (removed?)");
    require_two();
    check_beta(beta);
    require(frequency >= 0 && frequency < unbounded, "frequency", frequency,
            "must be finite and not negative [Hz]");
    require(damping >= 0 && damping < unbounded, "damping", damping,
            "must be finite and not negative [1]");
    require(push > 0, "push", push, "must be positive [m/s or rad/s]");
  }

  /// Called once per step, before append(). \param h step [s]
  /// \param duration for which the step's impulses act [s]; 0: h. Leapfrog may pass another one
  void begin_step(const Bodies& bodies, real h, real duration = 0) {
    h_ = h;
    impulse_duration_ = duration > 0 ? duration : h;
    can_move_ = !bodies.at(int(body1.slot)).is_static() || !bodies.at(int(body2.slot)).is_static();
    can_move_ ? update_active_rows(bodies, h) : deactivate();
  }
  /// True if at least one of its bodies was not static when the last step began.
  bool can_move() const { return can_move_; }
  /// Appends the active blocks at the bodies' present poses. It may be called again at other poses.
  virtual void append(const Bodies& bodies, Blocks& blocks) const = 0;
  /// Called after position projection has moved bodies, before the next append(): a joint that
  /// counts turns measures its angle again.
  virtual void after_projection(const Bodies&) {}
  /// Called after each solve if a body can move: appends limits that the new velocities would
  /// overshoot within this step, each at most once, with impulses of zero. \param h step [s]
  virtual void activate_missed_limits(const Bodies&, [[maybe_unused]] real h, Blocks&) {}
  /// The limits and motors of the joint, for reports.
  struct Stats {
    int limits = 0;        ///< coordinates that have limits, live or not
    int live_limits = 0;   ///< those with a limit that has a row in this step
    int motors = 0;        ///< coordinates with a motor that runs
    bool bounded = false;  ///< true if other rows have bounds, as in a rope
  };
  virtual Stats stats() const { return {}; }  ///< none by default
  /// True for joints that come and go while the world is stepped: a State does not contain them.
  virtual bool transient() const { return false; }
  /// The mean force of a row in the last step [N or N m]; 0 before the first step.
  /// \param impulse its accumulated impulse [N s or N m s]
  real mean_force(real impulse) const {
    return impulse_duration_ > 0 ? impulse / impulse_duration_ : real(0);
  }
  std::uint64_t number() const { return number_; }  ///< see JointId; 0 outside of a world
  real last_h() const { return h_; }  ///< length of the last step [s], 0 before the first
  /// Blocks::impulse_duration of the last step [s]; 0 before the first.
  real impulse_duration() const { return impulse_duration_; }
  /// For a way to move bodies that appends no rows. \param duration of the impulses [s]
  void set_impulse_duration(real duration) { impulse_duration_ = duration; }

 protected:
  /// The joint's own part of begin_step(): counts turns, chooses the active rows, sets the impulse
  /// of a row to zero that is no longer active. \param h step [s]
  virtual void update_active_rows(const Bodies&, [[maybe_unused]] real h) {}
  /// Called instead of update_active_rows() if both bodies are static. Then no row is active.
  virtual void deactivate() {}
  /// For engine/kept: lists every variable that a later step may read, such as accumulated
  /// impulses, always the same number of them in the same order.
  virtual void serialize(StateStream&) {}
  /// The settings of a block that holds a position: hard with beta, or soft with frequency and
  /// damping. \param lower 0 if the last row enforces C >= 0
  RowSettings hold(real lower = -unbounded) const {
    return {.beta = beta, .frequency = frequency, .damping = damping, .lower = lower,
            .push = push};
  }

 private:
  friend class World;
  friend void serialize(Joint& joint, StateStream& stream);
  bool can_move_ = true, removed_ = false;
  void require_two() const {
    require(!(body1 == body2), "body2: a joint needs two different bodies");
  }
  real h_ = 0, impulse_duration_ = 0;  // of the last step [s]
  std::size_t place_ = 0;     // in World::joints()
  std::uint64_t number_ = 0;  // of all joints that were ever added to a world
};

}  // namespace joints
/// @}
