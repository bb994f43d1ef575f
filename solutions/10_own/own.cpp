// Chapter 10: own joints. Replace each todo(...) by your own code; the text is in README.md.
#include "chapters/10_own/own.h"

#include <cmath>
#include <numbers>

#include "engine/instruments/todo.h"

namespace joints {

// ---- a universal joint -----------------------------------------------------------------------

real RightAngle::error(const Body& body1, const Body& body2) const {
  const vec3 a1 = to_world(body1, a1_local), a2 = to_world(body2, a2_local);
  // begin [exercise 10.1]
  // Return C: it is 0 where a1 and a2 are at right angles, and grows if a2 moves towards a1.
  return dot(a1, a2);  // Eq. 10-1
  // end [exercise 10.1]
}

Row RightAngle::jacobian(const Body& body1, const Body& body2) const {
  const vec3 a1 = to_world(body1, a1_local), a2 = to_world(body2, a2_local);
  // begin [exercise 10.1]
  // Return the row {v1, w1, v2, w2}: both factors of the product rotate.
  const vec3 n = cross(a1, a2);
  return {vec3(0), n, vec3(0), -n};  // Eq. 10-2
  // end [exercise 10.1]
}

// ---- a gear ----------------------------------------------------------------------------------

real Gear::error(const Body& body1, const Body& body2) const {
  const real theta1 = angle_of(angle1, body1), theta2 = angle_of(angle2, body2);
  // begin [exercise 10.2]
  // Return C [rad]: it is 0 while wheel 2 has turned `ratio` times as far as wheel 1.
  return theta2 - ratio * theta1;  // Eq. 10-4
  // end [exercise 10.2]
}

Row Gear::jacobian(const Body& body1, const Body& body2) const {
  const vec3 g1 = slope_of(angle1, body1), g2 = slope_of(angle2, body2);
  // begin [exercise 10.2]
  // Return the row: the rates of the two angles are g1.w1 and g2.w2.
  return {vec3(0), -ratio * g1, vec3(0), g2};  // Eq. 10-4
  // end [exercise 10.2]
}

void Gear::count(const Body& body1, const Body& body2, real h) {
  // begin [exercise 10.2]
  // Set angle1.expected and angle2.expected to where each angle will be after h seconds.
  angle1.expected = angle_of(angle1, body1) + h * dot(slope_of(angle1, body1), body1.w);
  angle2.expected = angle_of(angle2, body2) + h * dot(slope_of(angle2, body2), body2.w);
  // end [exercise 10.2]
}

// ---- a screw ---------------------------------------------------------------------------------

real Screw::error(const Body& body1, const Body& body2) const {
  const real s = slide.error(body1, body2), theta = angle.error(body1, body2);
  // begin [exercise 10.3]
  // Return C [m]: it is 0 while the nut has moved by `lead` along the axis per turn.
  return s - lead / (2 * std::numbers::pi_v<real>) * theta;  // Eq. 10-5
  // end [exercise 10.3]
}

Row Screw::jacobian(const Body& body1, const Body& body2) const {
  const Row along = slide.jacobian(body1, body2), about = angle.jacobian(body1, body2);
  // begin [exercise 10.3]
  // Return the same combination of the two rows, block by block.
  const real p = lead / (2 * std::numbers::pi_v<real>);
  return {along.v1, along.w1 - p * about.w1, along.v2, along.w2 - p * about.w2};  // Eq. 10-5
  // end [exercise 10.3]
}

// ---- a cone ----------------------------------------------------------------------------------

real Cone::error(const Body& body1, const Body& body2) const {
  const vec3 a1 = to_world(body1, a1_local), a2 = to_world(body2, a2_local);
  // begin [exercise 10.4]
  // Return C [rad]: how far the swing is below `limit`. It must be accurate at small swings, too.
  return limit - std::atan2(length(cross(a1, a2)), dot(a1, a2));  // Eq. 10-6
  // end [exercise 10.4]
}

Row Cone::jacobian(const Body& body1, const Body& body2) const {
  const vec3 a1 = to_world(body1, a1_local), a2 = to_world(body2, a2_local);
  // begin [exercise 10.4]
  // Return the row. Where the axes are parallel (the length of a1 x a2 is below 1e-6), take the
  // direction in which the bodies rotate: w2 - w1 without its part along a1; if that is 0, return a
  // row of zeros.
  vec3 n = cross(a1, a2);
  if (length(n) < real(1e-6)) {
    const vec3 w = body2.w - body1.w;
    n = w - dot(w, a1) * a1;
    if (length(n) == 0) return {};
  }
  n = normalize(n);
  return {vec3(0), n, vec3(0), -n};  // Eq. 10-7
  // end [exercise 10.4]
}

// ---- a part of your own ------------------------------------------------------------------------

OwnPart own_part(const Body& body1, const Body& body2) {
  // begin [exercise 10.5]
  // Return own(error, jacobian): two functions of two bodies. Here a point of body 2 stays in a
  // plane of body 1, as a puck on a table. Any other joint will do: give it the rows that it needs.
  const vec3 n_local = to_local(body1, vec3(0, 1, 0));
  const vec3 r1_local = to_local(body1, body2.x - body1.x);
  return own(
      [=](const Body& one, const Body& two) {
        const vec3 n = to_world(one, n_local);
        return dot(two.x - world_point(one, r1_local), n);
      },
      [=](const Body& one, const Body& two) {
        const vec3 n = to_world(one, n_local);
        return Row{-n, -cross(two.x - one.x, n), n, vec3(0)};
      });
  // end [exercise 10.5]
}

}  // namespace joints
