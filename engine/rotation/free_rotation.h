// How a body rotates in a step, so that its angular momentum is kept: the free rotation, and the
// mean rate with which rows are solved. body.h declares the two parts of a step that call it.
#pragma once

#include "engine/body.h"

/// \addtogroup bodies
/// @{
namespace joints {

/// Replaces w by the mean angular velocity of the next h seconds of free rotation. Rows that are
/// solved with it hold for the rotation that the body really does, and their impulses change the
/// angular momentum as usual. \param h step [s]
void use_mean_rate(Body& body, real h);
/// Takes back what use_mean_rate() has added: w is I^-1 L of the present pose again.
void use_own_rate(Body& body);
/// The rotation of a body on which no torque acts. Its angular momentum L [N m s, world] is kept,
/// so w changes if its moments of inertia differ.
///
/// The energy |L|^2/(2 I_m) + L_a^2 (1/I_a - 1/I_m)/2 + L_b^2 (1/I_b - 1/I_m)/2 has three terms,
/// with L_a and L_b along the body's axes of the largest and the smallest moment. Under each term
/// alone the body rotates at a constant rate: by h L/I_m about L in the world, and about its own
/// axis a by h L_a (1/I_a - 1/I_m), and about b likewise. The first rotation does not change the
/// others, which are done in the order half of a, all of b, half of a. So the result is exact if
/// two moments are equal, of second order and symmetric in time if they are not, and its energy
/// oscillates without a trend. Eq. 2-11. Source: Touma and Wisdom, "Lie-Poisson integrators for
/// rigid body dynamics in the solar system", 1994. \param h step [s]
void rotate_freely(Body& body, real h);

}  // namespace joints
/// @}
