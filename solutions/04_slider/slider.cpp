// Chapter 4: slider. Replace each todo(...) with your own code. README.md has the text.
#include "chapters/04_slider/slider.h"

#include "chapters/03_hinge/hinge.h"
#include "engine/instruments/todo.h"

namespace joints {

// ---- two rows: a point of body 2 stays on a line of body 1 ----------------------------------

Vector<2> Line::error(const Body& body1, const Body& body2) const {
  const vec3 u = world_point(body2, anchor2_local) - world_point(body1, anchor1_local);
  // begin [exercise 4.1]
  // Return the two numbers C of Eq. 4-2, made of u above and the two directions in world space. In
  // the axes of body 1 they are n1_local and n2_local.
  return {dot(u, to_world(body1, n1_local)), dot(u, to_world(body1, n2_local))};  // Eq. 4-2
  // end [exercise 4.1]
}

Jacobian<2> Line::jacobian(const Body& body1, const Body& body2) const {
  const vec3 u = world_point(body2, anchor2_local) - world_point(body1, anchor1_local);
  const vec3 n[2] = {to_world(body1, n1_local), to_world(body1, n2_local)};
  // begin [exercise 4.1]
  // Return the two rows J of Eq. 4-4, made of u and n[0], n[1] above and the levers r1 and r2.
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  Jacobian<2> J;
  for (int i = 0; i < 2; ++i)
    J[i] = {-n[i], -cross(r1 + u, n[i]), n[i], cross(r2, n[i])};  // Eq. 4-4
  return J;
  // end [exercise 4.1]
}

Matrix<2> Line::K(const Body& body1, const Body& body2) const {
  return K_of(jacobian(body1, body2), body1, body2);  // Eq. 4-5
}

// ---- three rows: the orientation of body 2 relative to body 1 -------------------------------

vec3 RotationLock::error(const Body& body1, const Body& body2) const {
  // begin [exercise 4.2]
  // Return C of Eq. 4-7: twice the vector part of the excess rotation, with the sign rule. The
  // member `start` is q_start.
  quat q = body2.q * conjugate(start) * conjugate(body1.q);
  if (q.w < 0) q = -q;
  return real(2) * vec3(q.x, q.y, q.z);  // Eq. 4-7
  // end [exercise 4.2]
}

Jacobian<3> RotationLock::jacobian([[maybe_unused]] const Body& body1,
                                    [[maybe_unused]] const Body& body2) const {
  // begin [exercise 4.2]
  // Return the three rows J of Eq. 4-8. jacobian_from_blocks(v1, w1, v2, w2) makes them from the
  // four 3x3 blocks.
  return jacobian_from_blocks(mat3(0), mat3(-1), mat3(0), mat3(1));  // Eq. 4-8
  // end [exercise 4.2]
}

mat3 RotationLock::K(const Body& body1, const Body& body2) const {
  return inverse_inertia(body1) + inverse_inertia(body2);  // Eq. 4-9
}

RotationLock lock_of(const Body& body1, const Body& body2) {
  return {normalize(conjugate(body1.q) * body2.q)};
}

// ---- one row: the displacement along the line ------------------------------------------------

real Slide::error(const Body& body1, const Body& body2) const {
  const vec3 u = world_point(body2, anchor2_local) - world_point(body1, anchor1_local);
  // begin [exercise 4.3]
  // Return the displacement of Eq. 4-10. In the axes of body 1 the line runs along a1_local.
  return dot(u, to_world(body1, a1_local));  // Eq. 4-10
  // end [exercise 4.3]
}

Row Slide::jacobian(const Body& body1, const Body& body2) const {
  const vec3 u = world_point(body2, anchor2_local) - world_point(body1, anchor1_local);
  // begin [exercise 4.3]
  // Return the row J of Eq. 4-11, the row of the displacement, for limit and motor.
  const vec3 a = to_world(body1, a1_local);
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  return {-a, -cross(r1 + u, a), a, cross(r2, a)};  // Eq. 4-11
  // end [exercise 4.3]
}

real Slide::K(const Body& body1, const Body& body2) const {
  const Row J = jacobian(body1, body2);
  return coupling(J, J, body1, body2);  // Eq. 4-12
}

}  // namespace joints
