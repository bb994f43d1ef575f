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
  todo("4.1");
  // end [exercise 4.1]
}

Jacobian<2> Line::jacobian(const Body& body1, const Body& body2) const {
  const vec3 u = world_point(body2, anchor2_local) - world_point(body1, anchor1_local);
  const vec3 n[2] = {to_world(body1, n1_local), to_world(body1, n2_local)};
  // begin [exercise 4.1]
  // Return the two rows J of Eq. 4-4, made of u and n[0], n[1] above and the levers r1 and r2.
  todo("4.1");
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
  todo("4.2");
  // end [exercise 4.2]
}

Jacobian<3> RotationLock::jacobian([[maybe_unused]] const Body& body1,
                                    [[maybe_unused]] const Body& body2) const {
  // begin [exercise 4.2]
  // Return the three rows J of Eq. 4-8. jacobian_from_blocks(v1, w1, v2, w2) makes them from the
  // four 3x3 blocks.
  todo("4.2");
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
  todo("4.3");
  // end [exercise 4.3]
}

Row Slide::jacobian(const Body& body1, const Body& body2) const {
  const vec3 u = world_point(body2, anchor2_local) - world_point(body1, anchor1_local);
  // begin [exercise 4.3]
  // Return the row J of Eq. 4-11, the row of the displacement, for limit and motor.
  todo("4.3");
  // end [exercise 4.3]
}

real Slide::K(const Body& body1, const Body& body2) const {
  const Row J = jacobian(body1, body2);
  return coupling(J, J, body1, body2);  // Eq. 4-12
}

}  // namespace joints
