// Chapter 7: the performance loop. Replace each todo(...) by your own code; the text is in
// README.md.
#include "chapters/07_performance/performance.h"

#include "engine/instruments/todo.h"
#ifndef JOINTS_REAL_HEADER  // lanes are of plain numbers
#include "engine/simd/lanes.h"
#endif

namespace joints {

// ---- what does not depend on the velocities ----------------------------------------------------

void hoist(const Hinge& hinge, const Body& body1, const Body& body2, real h,
           HingeNumbers<real>& out) {
  // begin [exercise 7.1]
  // Fill in r1, r2, axis_row, I1, I2 and bias, Eq. 7-1. to_world(body, lever) rotates a lever;
  // hinge.axis.jacobian(body1, body2)[i].w2 is an axis row; inverse_inertia(body) is a mat3;
  // triple() and symmetric() convert vec3 and mat3 into the types of HingeNumbers.
  todo("7.1");
  // end [exercise 7.1]
}

// ---- one block per joint -----------------------------------------------------------------------

Matrix<5> whole_K(const HingeNumbers<real>& hinge, real inverse_mass1, real inverse_mass2) {
  const std::array<Triple<real>, 2>& row = hinge.axis_row;
  Matrix<5> K;
  // begin [exercise 7.2]
  // Fill K with the three parts of Eq. 7-3: the point's 3x3, the axis' 2x2, and off the diagonal
  // the columns -(r1 x I1 a + r2 x I2 a) and their transpose. hinge.I1 * row[i] is a Triple;
  // cross() and dot() accept Triples.
  todo("7.2");
  // end [exercise 7.2]
  return K;
}

// ---- graph colouring ---------------------------------------------------------------------------

std::vector<int> colours_of(const std::vector<BodyPair>& links, const std::vector<bool>& moves) {
  // begin [exercise 7.3]
  // For each body store the colours that its joints have so far, for example as
  // taken[body][colour]. Each joint in turn takes the lowest colour that is free at both its
  // bodies. A static body blocks no colour; its joints still get one.
  todo("7.3");
  // end [exercise 7.3]
}

// ---- the solve of a block, scalar or on lanes --------------------------------------------------

template <class Number>
void solve(const HingeNumbers<Number>& hinge, Velocities<Number>& body1,
           Velocities<Number>& body2) {
  // begin [exercise 7.4]
  // Eq. 7-6 in four steps: the velocity errors e = bias + J V; K^-1 e by
  // hinge.inverse_K_times(e, out), which is -lambda; the linear impulse and the couple of lambda;
  // and the changes of the velocities. Use only + - * and the functions of Triple, which lanes have
  // as well.
  todo("7.4");
  // end [exercise 7.4]
}

template void solve(const HingeNumbers<real>&, Velocities<real>&, Velocities<real>&);
#ifndef JOINTS_REAL_HEADER
template void solve(const HingeNumbers<Lanes>&, Velocities<Lanes>&, Velocities<Lanes>&);
#endif

}  // namespace joints
