// The free coordinate of a joint: its limits as parts, its whole turns, and when it need not be
// measured. Given: there is nothing to edit here.
#pragma once

#include "chapters/03_hinge/hinge.h"
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

  static constexpr int rows = 1;           ///< one row
  static constexpr bool one_sided = true;  ///< its impulse only increases C
  static constexpr Form form = Coordinate::form;  ///< the form of its row
  /// C, the gap to the limit [rad or m]; negative beyond it.
  real error(const Body& body1, const Body& body2) const {
    return sign * (coordinate.error(body1, body2) - bound);
  }
  /// The row of the coordinate, times the sign of the limit.
  Row jacobian(const Body& body1, const Body& body2) const {
    const Row J = coordinate.jacobian(body1, body2);
    return {sign * J.v1, sign * J.w1, sign * J.v2, sign * J.w2};
  }
};

/// The largest magnitude of a finite limit [rad or m].
constexpr real max_limit = real(1e9);
/// \throws std::invalid_argument unless lower <= upper and both are infinite or within max_limit
inline void check(const Range& range) {
  const auto [lower, upper] = range;
  require(lower <= upper && lower < unbounded && upper > -unbounded,
          "lower: must not be above upper, and neither infinite on its wrong side [rad or m]");
  for (const real bound : {lower, upper})
    require(std::abs(bound) <= max_limit || std::abs(bound) == unbounded,
            bound == lower ? "lower" : "upper", bound,
            "must be within 1e9 [rad or m]; infinite for no limit");
}
/// \throws std::invalid_argument unless the speed is within max_speed and the strength at least 0
inline void check(const Motor& motor) {
  require(std::abs(motor.speed) <= max_speed, "speed", motor.speed,
          "must be within 3e8 [rad/s or m/s]");
  require(motor.strength >= 0, "strength", motor.strength, "must not be negative [N m or N]");
}

/// Makes an angle count its turns to within half a turn of `expected` [rad]. A displacement has no
/// turns, so this general version does nothing.
template <class Coordinate>
void count_from(Coordinate&, [[maybe_unused]] real expected) {}
/// Saves or restores the number of turns of an angle (Joint::exchange). A displacement has none.
template <class Coordinate>
void exchange_turns(Coordinate&, StateStream&) {}

/// Decides when a step need not measure the coordinate, because its limits are out of reach. This
/// general version always measures. The one in hinge_joint.h skips the atan2 of a hinge.
template <class Coordinate>
struct Leeway {
  /// Called after each measurement. \param slack distance to the nearer limit [rad or m]
  void measured(const Coordinate&, const Body&, const Body&, [[maybe_unused]] real slack) {}
  void forget() {}  ///< the next step measures in any case
  void exchange(StateStream&) {}  ///< saves or restores the measurement (Joint::exchange)
  /// True if the rotations since the measurement cannot have used up half of the slack.
  bool still_near(const Body&, const Body&) const { return false; }
  /// True if this step, at the present velocities, cannot use up the other half. \param h step [s]
  bool is_slow(const Body&, const Body&, [[maybe_unused]] real h) const { return false; }
};

}  // namespace joints
/// @}
