// What every joint is: a recipe that turns two bodies into blocks, once a step.
#pragma once

#include "engine/block.h"

/// \defgroup joint Joints
/// \brief What the engine asks of a joint; the joints themselves are the chapters'.
/// @{
namespace joints {

/// A recipe for blocks. The solver asks once a step, never in its inner loop.
/// A new kind of joint is one new class in one new file; nothing else has to know it.
class Joint {
 public:
  BodyId body1, body2;    ///< the two bodies it holds
  real beta = real(0.2);  ///< share of the error fed back in a step [1] (chapter 6)
  bool projected = true;  ///< takes part in the solver's position projection, if that is on

  /// \throws std::invalid_argument for a joint of a body with itself
  Joint(BodyId body1, BodyId body2) : body1(body1), body2(body2) {
    require(!(body1 == body2), "body2: a joint needs two different bodies");
  }
  virtual ~Joint() = default;

  /// Called once a step, before the blocks are asked for. \param h step [s]
  void begin_step(const Bodies& bodies, real h) {
    h_ = h;
    can_move_ = !bodies.at(int(body1.slot)).is_static() || !bodies.at(int(body2.slot)).is_static();
    can_move_ ? choose_rows(bodies, h) : drop_rows();
  }
  /// Could one of its bodies be moved when the last step began?
  bool can_move() const { return can_move_; }
  /// Appends the live blocks at the bodies' present poses. Has no side effect, so that it may be
  /// asked again at other poses.
  virtual void append(const Bodies& bodies, Blocks& blocks) const = 0;
  /// Called when the bodies were moved without a velocity (position projection), before the blocks
  /// are asked for at the new poses: a joint that counts turns looks again.
  virtual void moved(const Bodies&) {}
  /// Called after the solve, where a body can move: appends the blocks of limits that the new
  /// velocities would pass within this step. \param h step [s]
  virtual void late_limits(const Bodies&, [[maybe_unused]] real h, Blocks&) {}
  /// The most rows that append and late_limits can ever give together.
  virtual int most_rows() const = 0;
  /// What the joint has of limits and motors, for the plan line.
  struct Extras {
    int limits = 0;       ///< 1 where its coordinate has limits, live or not
    int live_limits = 0;  ///< 1 where one of them has a row at present
    int motors = 0;       ///< 1 where a motor runs
  };
  virtual Extras extras() const { return {}; }  ///< none, unless a joint says otherwise

  /// The mean force in the last step of a row with this impulse, impulse / h [N or N m]; 0 before
  /// the first step.
  real in_step(real impulse) const { return h_ > 0 ? impulse / h_ : real(0); }
  real last_h() const { return h_; }  ///< length of the last step [s], 0 before the first

 protected:
  /// The joint's own part of begin_step(): may change the joint (count turns, choose the live rows,
  /// zero the impulse of a row that died). \param h step [s]
  virtual void choose_rows(const Bodies&, [[maybe_unused]] real h) {}
  /// Called in its place between two static bodies: no row is live.
  virtual void drop_rows() {}

 private:
  real h_ = 0;  // the last step [s]
  bool can_move_ = true;
};

}  // namespace joints
/// @}
