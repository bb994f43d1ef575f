// What acts on the coordinate of a link: motor or servo, friction, limits, spring. Given, there is
// nothing to edit here.
#pragma once

#include <array>

#include "chapters/11_reduced/reduced.h"
#include "joints/limits_and_springs.h"

/// \defgroup reduced Reduced coordinates
/// \brief Trees of joints with one number per degree of freedom.
/// @{
namespace joints {

/// The settings of a free coordinate, as joints/free_coordinate.h explains them.
struct DriveSettings {
  Range limits;             ///< [rad or m]
  Motor motor;              ///< its speed is the greatest one of a servo
  real target = unbounded;  ///< of a servo [rad or m]; infinite for a motor
  real friction = 0;        ///< dry friction [N m or N]
  Spring spring;            ///< spring and damper
  real beta = 0;            ///< Joint::beta, for servo and limits [1]
};

/// A coordinate and all that acts on it within half a step. Motor, friction and limits are steps of
/// one staircase: the force that they can exert, as a function of the rate at the end. At a
/// threshold the force is any between `below` and `above`, and the rate is known; between two
/// thresholds the force is known. A spring adds a force that is linear in the acceleration.
struct Drive {
  /// A step of the staircase.
  struct Threshold {
    real rate = 0;   ///< where it is [rad/s or m/s]
    real below = 0;  ///< force at lower rates [N m or N]
    real above = 0;  ///< force at higher rates, not greater [N m or N]
    int item = 0;    ///< 0: motor, 1: friction, 2: lower limit, 3: upper limit
  };
  int link = 0;            ///< index of the link
  DriveSettings settings;  ///< of this step
  std::array<Threshold, 4> thresholds{};  ///< by increasing rate
  int count = 0;           ///< number of thresholds
  std::array<real, 4> constant{};  ///< force of a motor or friction beyond a limit [N m or N]
  int place = 0;           ///< 2 k: between thresholds k - 1 and k; 2 k + 1: at threshold k
  int held_item = -1;      ///< the item of the last half step's threshold; -1: at none
  real spring = 0;         ///< force of the spring at acceleration 0 [N m or N]
  real added = 0;          ///< decrease of that force per unit of acceleration [kg m^2 or kg]
  real at = 0;             ///< how far its force or rate has come along the path of all drives
  int clipped = 0;         ///< its strength is reached: sign of its force, or 0
  std::array<real, 4> impulse{};  ///< of motor, friction, limits, spring in this step [N m s, N s]

  /// Computes the thresholds and the spring's force. \param h the whole step [s]
  /// \param first of the two halves of the step
  void begin(const TreeLink& link, real h, bool first);
  /// Sets what the place determines: the known motion or the known force of the link.
  /// \return true if the inertia has to be eliminated again \param base the rate at the beginning
  /// of the half step [rad/s or m/s] \param half length of the half step [s]
  bool apply(TreeLink& link, real base, real half) const;
  /// What is free in a place, force at a threshold or rate between two, and where the place ends.
  struct Span {
    real least, most;  ///< the ends of the place [N m, N, rad/s or m/s]
    real value;        ///< force or rate at the present acceleration
    real slop;         ///< by which rounding may take the value out of its place
    /// On which side of the place the value is; 0: within it.
    int side() const { return value > most + slop ? 1 : value < least - slop ? -1 : 0; }
  };
  /// The span at the link's present acceleration; a spring at its strength is a place, too.
  /// \param base, half as in apply()
  Span span(const TreeLink& link, real base, real half) const;
  /// Goes to the neighbouring place on the side of the value.
  void cross(const Span& span);
  /// Adds the impulses of a half step. \param half its length [s]
  void add_impulses(const TreeLink& link, real half);

 private:
  real force(int number) const;  // of all thresholds, between threshold number - 1 and number
  real spring_force(const TreeLink& link) const;
};

}  // namespace joints
/// @}
