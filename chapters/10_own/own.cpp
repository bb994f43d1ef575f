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
  todo("10.1");
  // end [exercise 10.1]
}

Row RightAngle::jacobian(const Body& body1, const Body& body2) const {
  const vec3 a1 = to_world(body1, a1_local), a2 = to_world(body2, a2_local);
  // begin [exercise 10.1]
  // Return the row {v1, w1, v2, w2}: both factors of the product rotate.
  todo("10.1");
  // end [exercise 10.1]
}

// ---- a gear ----------------------------------------------------------------------------------

real Gear::error(const Body& body1, const Body& body2) const {
  const real theta1 = angle_of(angle1, body1), theta2 = angle_of(angle2, body2);
  // begin [exercise 10.2]
  // Return C [rad]: it is 0 while wheel 2 has turned `ratio` times as far as wheel 1.
  todo("10.2");
  // end [exercise 10.2]
}

Row Gear::jacobian(const Body& body1, const Body& body2) const {
  const vec3 g1 = slope_of(angle1, body1), g2 = slope_of(angle2, body2);
  // begin [exercise 10.2]
  // Return the row: the rates of the two angles are g1.w1 and g2.w2.
  todo("10.2");
  // end [exercise 10.2]
}

void Gear::count(const Body& body1, const Body& body2, real h) {
  // begin [exercise 10.2]
  // Set angle1.expected and angle2.expected to where each angle will be after h seconds.
  todo("10.2");
  // end [exercise 10.2]
}

// ---- a screw ---------------------------------------------------------------------------------

real Screw::error(const Body& body1, const Body& body2) const {
  const real s = slide.error(body1, body2), theta = angle.error(body1, body2);
  // begin [exercise 10.3]
  // Return C [m]: it is 0 while the nut has moved by `lead` along the axis per turn.
  todo("10.3");
  // end [exercise 10.3]
}

Row Screw::jacobian(const Body& body1, const Body& body2) const {
  const Row along = slide.jacobian(body1, body2), about = angle.jacobian(body1, body2);
  // begin [exercise 10.3]
  // Return the same combination of the two rows, block by block.
  todo("10.3");
  // end [exercise 10.3]
}

// ---- a cone ----------------------------------------------------------------------------------

real Cone::error(const Body& body1, const Body& body2) const {
  const vec3 a1 = to_world(body1, a1_local), a2 = to_world(body2, a2_local);
  // begin [exercise 10.4]
  // Return C [rad]: how far the swing is below `limit`. It must be accurate at small swings, too.
  todo("10.4");
  // end [exercise 10.4]
}

Row Cone::jacobian(const Body& body1, const Body& body2) const {
  const vec3 a1 = to_world(body1, a1_local), a2 = to_world(body2, a2_local);
  // begin [exercise 10.4]
  // Return the row. Where the axes are parallel (the length of a1 x a2 is below 1e-6), take the
  // direction in which the bodies rotate: w2 - w1 without its part along a1; if that is 0, return a
  // row of zeros.
  todo("10.4");
  // end [exercise 10.4]
}

// ---- a part of your own ------------------------------------------------------------------------

OwnPart own_part(const Body& body1, const Body& body2) {
  // begin [exercise 10.5]
  // Return own(error, jacobian): two functions of two bodies. Here a point of body 2 stays in a
  // plane of body 1, as a puck on a table. Any other joint will do: give it the rows that it needs.
  todo("10.5");
  // end [exercise 10.5]
}

}  // namespace joints
