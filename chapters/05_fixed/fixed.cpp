// Chapter 5: fixed joint. Replace each todo(...) by your own code; the text is in README.md.
#include "chapters/05_fixed/fixed.h"

#include "engine/instruments/todo.h"

namespace joints {

// ---- six rows in one block ---------------------------------------------------------------------

mat3 cross_K(const Point& point, const Body& body1, const Body& body2) {
  // begin [exercise 5.1]
  // Return the 3x3 matrix X of Eq. 5-2. skew(r) is the matrix of the product r x, and
  // inverse_inertia(body) is the inverse inertia in world axes.
  todo("5.1");
  // end [exercise 5.1]
}

Matrix<6> weld_K(const Weld& weld, const Body& body1, const Body& body2) {
  const mat3 upper = weld.first.K(body1, body2), lower = weld.second.K(body1, body2);
  const mat3 X = cross_K(weld.first, body1, body2);
  Matrix<6> K;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {  // GLM counts columns first: A[column][row]
      K[i][j] = upper[j][i];
      K[i][3 + j] = K[3 + j][i] = X[j][i];  // Eq. 5-3
      K[3 + i][3 + j] = lower[j][i];
    }
  return K;
}

// ---- the load of a weld ---------------------------------------------------------------------

Reaction carried(const Vector<6>& impulse, real h) {
  // begin [exercise 5.2]
  // Return {force, torque} of Eq. 5-4. The first three impulses belong to the point and act at the
  // anchor; the last three belong to the lock and are couples.
  todo("5.2");
  // end [exercise 5.2]
}

Reaction about(const Reaction& load, const vec3& from, const vec3& to) {
  // begin [exercise 5.2]
  // Return the same load with its torque expressed about the point `to`, Eq. 5-5.
  todo("5.2");
  // end [exercise 5.2]
}

bool breaks(const Reaction& load, const Strength& strength) {
  // begin [exercise 5.2]
  // Return true if the magnitude of the force or of the torque exceeds its bound.
  todo("5.2");
  // end [exercise 5.2]
}

// ---- a joint of your own --------------------------------------------------------------------

FourRows sleeve(const Kit& kit, const Body& body1, const Body& body2) {
  // begin [exercise 5.3]
  // Choose the parts of the kit that leave a sleeve its sliding and its rotation, and nothing else.
  // Return C, J and K of all their rows as one block, those of a translation first.
  // coupling(a, b, body1, body2) of chapter 3 is a M^-1 b^T for any two rows.
  todo("5.3");
  // end [exercise 5.3]
}

Reaction transmitted(const Jacobian<4>& J, const Vector<4>& impulse, real h, const Body& body2,
                     const vec3& seam) {
  // begin [exercise 5.3]
  // The rows have any direction. Ask of each: which impulse, and which angular impulse about the
  // centre, does it apply to body 2? Return the mean force, and the mean torque about `seam`.
  todo("5.3");
  // end [exercise 5.3]
}

}  // namespace joints
