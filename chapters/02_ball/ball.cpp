// Chapter 2: a block of three rows. Replace each todo(...) with your own code. README.md has the
// text.
#include "chapters/02_ball/ball.h"

#include "engine/instruments/todo.h"

namespace joints {

// ---- the part: a point of body 1 held to a point of body 2 ---------------------------------

Jacobian<3> Point::jacobian(const Body& body1, const Body& body2) const {
  // begin [exercise 2.1]
  // Return the three rows J of Eq. 2-4. jacobian_from_blocks(v1, w1, v2, w2) makes them from the
  // four 3x3 blocks. mat3(1) is the unit matrix E, and skew(r) a is r x a.
  todo("2.1");
  // end [exercise 2.1]
}

mat3 Point::K(const Body& body1, const Body& body2) const {
  // begin [exercise 2.2]
  // Return the 3x3 matrix K of Eq. 2-6. inverse_inertia(body) is in world axes.
  todo("2.2");
  // end [exercise 2.2]
}

// ---- the impulse of a block -----------------------------------------------------------------

vec3 block_impulse(const Jacobian<3>& J, const mat3& K, const vec3& bias, const Body& body1,
                   const Body& body2) {
  // begin [exercise 2.3]
  // Return lambda of Eq. 2-7. row_velocity(J[i], body1, body2) is J V of row i, and inverse(K) is
  // the inverse of a mat3.
  todo("2.3");
  // end [exercise 2.3]
}

void apply_impulse(const Jacobian<3>& J, const vec3& lambda, Body& body1, Body& body2) {
  // begin [exercise 2.3]
  // Change the velocities of both bodies by M^-1 J^T lambda, Eq. 2-8. Each row contributes its own
  // lambda[i] times J[i].v1, J[i].w1, J[i].v2, J[i].w2, as the one row of exercise 1.3 did.
  todo("2.3");
  // end [exercise 2.3]
}

// ---- the rotation of a body in a step ---------------------------------------------------------

quat turned(const quat& q, const vec3& w, real h) {
  // begin [exercise 2.4]
  // Return exp(h w) q, normalised, Eq. 2-10. quat(w, x, y, z) makes a quaternion. If the angle
  // |h w| is zero, return q instead of dividing by it.
  todo("2.4");
  // end [exercise 2.4]
}

void tumble(Body& body, real h) {
  // begin [exercise 2.5]
  // L = angular_momentum(body) is held. With the axes a, m, b of axes_by_moment(body), rotate the
  // body as Eq. 2-11 says: half about its axis a, all about b, half about a, and then about L. Each
  // is a call of turned with a rate in world axes; to_world(body, e) is the body's axis e there.
  // Last, w follows from L and the new orientation.
  todo("2.5");
  // end [exercise 2.5]
}

}  // namespace joints
