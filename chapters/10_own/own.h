// Chapter 10: joints of your own. Declares the functions that own.cpp has to define. Read README.md
// in this folder first. Given: there is nothing to edit here.
#pragma once

#include <functional>

#include "chapters/02_ball/ball.h"
#include "chapters/03_hinge/hinge.h"
#include "chapters/04_slider/slider.h"
#include "engine/parts/part.h"

/// \defgroup chapter10 Chapter 10: joints of your own
/// \brief A universal joint, a gear, a screw, a cone, and a part that no chapter has.
/// @{
namespace joints {

// ---- 10.1: a universal joint -----------------------------------------------------------------

/// Keeps an axis of body 1 at right angles to an axis of body 2. Removes one degree of freedom.
///
/// a1 = R1 a1_local, a2 = R2 a2_local; C = a1.a2 [1]; J = (0, (a1 x a2)^T, 0, -(a1 x a2)^T), exact
/// at every pose; K = (a1 x a2).(I1^-1 + I2^-1)(a1 x a2) [1/(kg m^2)]. Where the axes are parallel,
/// J is zero and the row has no effect. Below a point it makes a universal joint.
/// Source: one of the two numbers of Eq. 3-2, between axes that are not meant to be parallel.
struct RightAngle {
  vec3 a1_local{1, 0, 0};  ///< an axis of body 1, unit, body space
  vec3 a2_local{0, 1, 0};  ///< an axis of body 2, unit, body space

  static constexpr int rows = 1;               ///< degrees of freedom that it removes
  static constexpr bool one_sided = false;     ///< both signs of impulse are allowed
  static constexpr Form form = Form::angular;  ///< the form of its row
  real error(const Body& body1, const Body& body2) const;    ///< exercise 10.1 [1]
  Row jacobian(const Body& body1, const Body& body2) const;  ///< exercise 10.1
};

// ---- 10.2: a gear ----------------------------------------------------------------------------

/// The angle of one body about an axis that is fixed in the world, with its turns [rad].
inline real angle_of(const HingeAngle& angle, const Body& body) {
  return angle.error(Body{}, body);
}
/// The slope of that angle, g of Eq. 3-10: its rate is g.w [1].
inline vec3 slope_of(const HingeAngle& angle, const Body& body) {
  return angle.jacobian(Body{}, body).w2;
}

/// Two wheels on axles of a fixed housing: wheel 2 turns `ratio` times as fast as wheel 1. Removes
/// one degree of freedom.
///
/// C = angle2 - ratio angle1 [rad]; J = (0, -ratio g1^T, 0, g2^T), exact at every pose below half a
/// turn of misalignment; K = ratio^2 g1.I1^-1 g1 + g2.I2^-1 g2 [1/(kg m^2)], never singular while a
/// wheel can move. It exchanges momentum with the housing, which is not one of the two bodies: on a
/// housing that moves the row would need a third body. Source: ours; the angles are those of the
/// thesis, section 3.7.3, corrected.
struct Gear {
  HingeAngle angle1;  ///< of wheel 1 about its axle, whose direction is in world space
  HingeAngle angle2;  ///< of wheel 2 about its axle
  real ratio = 1;     ///< turns of wheel 2 per turn of wheel 1 [1]; negative if the wheels mesh

  static constexpr int rows = 1;            ///< degrees of freedom that it removes
  static constexpr bool one_sided = false;  ///< both signs of impulse are allowed
  static constexpr Form form = Form::any;   ///< w1 and w2 differ
  real error(const Body& body1, const Body& body2) const;    ///< exercise 10.2 [rad]
  Row jacobian(const Body& body1, const Body& body2) const;  ///< exercise 10.2
  /// Exercise 10.2: sets `expected` of both angles to their values after the coming step, so that
  /// they keep their turns. \param h step [s]
  void count(const Body& body1, const Body& body2, real h);
};

// ---- 10.3: a screw ---------------------------------------------------------------------------

/// A nut (body 2) on a screw (body 1): a turn moves it by `lead` along the axis. Removes one degree
/// of freedom; a line and an axis remove the other four.
///
/// C = slide - lead angle / (2 pi) [m]; J is the same combination of Eq. 4-11 and Eq. 3-10, exact
/// at every pose below half a turn of misalignment; K = J M^-1 J^T [1/kg], never singular.
/// Source: ours; the two coordinates are those of chapters 3 and 4.
struct Screw {
  Slide slide;       ///< displacement along the axis of the screw
  HingeAngle angle;  ///< rotation about it
  real lead = 1;     ///< displacement per turn [m]; negative for a left-handed thread

  static constexpr int rows = 1;            ///< degrees of freedom that it removes
  static constexpr bool one_sided = false;  ///< both signs of impulse are allowed
  static constexpr Form form = Form::any;   ///< it has levers and an angular part
  real error(const Body& body1, const Body& body2) const;    ///< exercise 10.3 [m]
  Row jacobian(const Body& body1, const Body& body2) const;  ///< exercise 10.3
  /// Keeps the turns. \param h step [s]
  void count(const Body& body1, const Body& body2, real h) {
    const Row J = angle.jacobian(body1, body2);
    angle.expected = angle.error(body1, body2) + h * row_velocity(J, body1, body2);
  }
};

// ---- 10.4: a cone ----------------------------------------------------------------------------

/// Keeps an axis of body 2 within a cone about an axis of body 1, as in a shoulder. One-sided.
///
/// The swing is the angle between the axes, atan2(|a1 x a2|, a1.a2); C = limit - swing >= 0 [rad];
/// J = (0, n^T, 0, -n^T) with n = a1 x a2 / |a1 x a2|, exact at every swing but 0 and pi;
/// K = n.(I1^-1 + I2^-1) n [1/(kg m^2)]. At swing 0 every direction leads away from the axis; the
/// row takes the one in which the bodies are moving. Source: the swing of a swing-twist
/// decomposition; the direction at swing 0 is ours.
struct Cone {
  vec3 a1_local{1, 0, 0};  ///< the axis of the cone, unit, body space of body 1
  vec3 a2_local{1, 0, 0};  ///< the axis that stays inside, unit, body space of body 2
  real limit = 1;          ///< the greatest swing, above 0 and below pi [rad]

  static constexpr int rows = 1;               ///< degrees of freedom that it removes at the limit
  static constexpr bool one_sided = true;      ///< it only pushes back
  static constexpr Form form = Form::angular;  ///< the form of its row
  real error(const Body& body1, const Body& body2) const;    ///< exercise 10.4 [rad]
  Row jacobian(const Body& body1, const Body& body2) const;  ///< exercise 10.4
};

// ---- 10.5: a part of your own ------------------------------------------------------------------

/// A part whose number of rows is known only when the program runs: two functions of two bodies.
struct OwnPart {
  int rows = 0;            ///< 1 to 6
  bool one_sided = false;  ///< true: its last row holds C >= 0
  std::function<std::array<real, 6>(const Body&, const Body&)> error;    ///< C; `rows` are used
  std::function<std::array<Row, 6>(const Body&, const Body&)> jacobian;  ///< J; `rows` are used
};

/// Makes a part of two functions of two bodies. \param error returns C: a real, a vec3, or a
/// Vector<N> \param jacobian returns J: a Row, or a Jacobian<N> of as many rows
/// \param one_sided true: the last row holds C >= 0
template <class Error, class Slope>
OwnPart own(const Error& error, const Slope& jacobian, bool one_sided = false) {
  using Column = std::remove_cvref_t<decltype(to_vector(error(Body{}, Body{})))>;
  constexpr int rows = int(std::tuple_size_v<Column>);
  static_assert(rows >= 1 && rows <= 6, "a part has one to six rows");
  OwnPart part{rows, one_sided, nullptr, nullptr};
  part.error = [error](const Body& body1, const Body& body2) {
    const auto C = error(body1, body2);
    std::array<real, 6> out{};
    for (int i = 0; i < rows; ++i) out[std::size_t(i)] = to_vector(C)[std::size_t(i)];
    return out;
  };
  part.jacobian = [jacobian](const Body& body1, const Body& body2) {
    const auto J = jacobian(body1, body2);
    const Jacobian<rows>& all = to_jacobian(J);
    std::array<Row, 6> out{};
    for (int i = 0; i < rows; ++i) out[std::size_t(i)] = all[i];
    return out;
  };
  return part;
}

#ifndef JOINTS_LIBRARY  // exercises, which programs that link the library do not see
/// Exercise 10.5: a joint that no chapter has, between two bodies in their present poses, where its
/// C is 0. Any number of rows.
OwnPart own_part(const Body& body1, const Body& body2);
#endif

}  // namespace joints
/// @}
