// Chapter 2: a block of three rows. Replace each todo(...) by your own code; the text is in
// README.md.
#include "chapters/02_ball/ball.h"

namespace joints {

// ---- the part: a point of body 1 held to a point of body 2 ---------------------------------

Jacobian<3> Point::jacobian(const Body& body1, const Body& body2) const {
  // begin [exercise 2.1]
  // Return the three rows J of Eq. 2-4. jacobian_from_blocks(v1, w1, v2, w2) makes them from the
  // four 3x3 blocks; mat3(1) is the unit matrix E, skew(r) the matrix of r x.
  todo("2.1");
  // end [exercise 2.1]
}

mat3 Point::K(const Body& body1, const Body& body2) const {
  // begin [exercise 2.2]
  // Return the 3x3 matrix K of Eq. 2-6. inverse_inertia(body) is the world inverse inertia.
  todo("2.2");
  // end [exercise 2.2]
}

// ---- the impulse of a block -----------------------------------------------------------------

vec3 block_impulse(const Jacobian<3>& J, const mat3& K, const vec3& bias, const Body& body1,
                   const Body& body2) {
  // begin [exercise 2.3]
  // Return lambda of Eq. 2-7. row_velocity(J[i], body1, body2) is J V of row i, inverse(K) GLM's.
  todo("2.3");
  // end [exercise 2.3]
}

void apply_impulse(const Jacobian<3>& J, const vec3& lambda, Body& body1, Body& body2) {
  // begin [exercise 2.3]
  // Change the velocities of both bodies by M^-1 J^T lambda, Eq. 2-8: each row pushes with its own
  // lambda[i] along J[i].v1, J[i].w1, J[i].v2, J[i].w2, as the one row of exercise 1.3 did.
  todo("2.3");
  // end [exercise 2.3]
}

// ---- the rotation of a body in a step ---------------------------------------------------------

quat turned(const quat& q, const vec3& w, real h) {
  // begin [exercise 2.4]
  // Return exp(h w) q, normalised, Eq. 2-10. A quaternion is made by quat(w, x, y, z). If the angle
  // |h w| is zero, do not divide by it: return q.
  todo("2.4");
  // end [exercise 2.4]
}

}  // namespace joints
