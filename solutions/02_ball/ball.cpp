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
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  return jacobian_from_blocks(mat3(-1), skew(r1), mat3(1), -skew(r2));  // Eq. 2-4
  // end [exercise 2.1]
}

mat3 Point::K(const Body& body1, const Body& body2) const {
  // begin [exercise 2.2]
  // Return the 3x3 matrix K of Eq. 2-6. inverse_inertia(body) is in world axes.
  const mat3 s1 = skew(to_world(body1, anchor1_local)), s2 = skew(to_world(body2, anchor2_local));
  return mat3(body1.inverse_mass + body2.inverse_mass) +
         s1 * inverse_inertia(body1) * transpose(s1) +
         s2 * inverse_inertia(body2) * transpose(s2);  // Eq. 2-6
  // end [exercise 2.2]
}

// ---- the impulse of a block -----------------------------------------------------------------

vec3 block_impulse(const Jacobian<3>& J, const mat3& K, const vec3& bias, const Body& body1,
                   const Body& body2) {
  // begin [exercise 2.3]
  // Return lambda of Eq. 2-7. row_velocity(J[i], body1, body2) is J V of row i, and inverse(K) is
  // the inverse of a mat3.
  vec3 e = bias;
  for (int i = 0; i < 3; ++i) e[i] += row_velocity(J[i], body1, body2);
  return -inverse(K) * e;  // Eq. 2-7
  // end [exercise 2.3]
}

void apply_impulse(const Jacobian<3>& J, const vec3& lambda, Body& body1, Body& body2) {
  // begin [exercise 2.3]
  // Change the velocities of both bodies by M^-1 J^T lambda, Eq. 2-8. Each row contributes its own
  // lambda[i] times J[i].v1, J[i].w1, J[i].v2, J[i].w2, as the one row of exercise 1.3 did.
  for (int i = 0; i < 3; ++i) {
    body1.v += body1.inverse_mass * lambda[i] * J[i].v1;  // Eq. 2-8
    body1.w += inverse_inertia(body1) * (lambda[i] * J[i].w1);
    body2.v += body2.inverse_mass * lambda[i] * J[i].v2;
    body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2);
  }
  // end [exercise 2.3]
}

// ---- the rotation of a body in a step ---------------------------------------------------------

quat turned(const quat& q, const vec3& w, real h) {
  // begin [exercise 2.4]
  // Return exp(h w) q, normalised, Eq. 2-10. quat(w, x, y, z) makes a quaternion. If the angle
  // |h w| is zero, return q instead of dividing by it.
  const real angle = h * length(w);
  if (angle == 0) return q;
  const vec3 axis = w / length(w);
  const vec3 v = std::sin(angle / 2) * axis;
  return normalize(quat(std::cos(angle / 2), v.x, v.y, v.z) * q);  // Eq. 2-10
  // end [exercise 2.4]
}

void tumble(Body& body, real h) {
  // begin [exercise 2.5]
  // L = angular_momentum(body) is held. With the axes a, m, b of axes_by_moment(body), rotate the
  // body as Eq. 2-11 says: half about its axis a, all about b, half about a, and then about L. Each
  // is a call of turned with a rate in world axes; to_world(body, e) is the body's axis e there.
  // Last, w follows from L and the new orientation.
  const vec3 L = angular_momentum(body), inverse = body.inverse_inertia_local;
  const auto [a, m, b] = axes_by_moment(body);
  for (const auto& [i, time] : {std::pair(a, h / 2), std::pair(b, h), std::pair(a, h / 2)}) {
    vec3 axis(0);
    axis[i] = 1;
    axis = to_world(body, axis);
    const real rate = dot(L, axis) * (inverse[i] - inverse[m]);  // Eq. 2-11
    body.q = turned(body.q, rate * axis, time);
  }
  body.q = turned(body.q, inverse[m] * L, h);
  body.w = inverse_inertia(body) * L;
  // end [exercise 2.5]
}

}  // namespace joints
