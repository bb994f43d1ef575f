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
  out.r1 = triple(to_world(body1, hinge.point.anchor1_local));  // Eq. 7-1
  out.r2 = triple(to_world(body2, hinge.point.anchor2_local));
  const Jacobian<2> axis = hinge.axis.jacobian(body1, body2);
  for (int i = 0; i < 2; ++i) out.axis_row[i] = triple(axis[i].w2);
  out.I1 = symmetric(inverse_inertia(body1));
  out.I2 = symmetric(inverse_inertia(body2));
  const real rate = hinge.beta / h;
  const vec3 gap = hinge.point.error(body1, body2);
  const Vector<2> tilt = hinge.axis.error(body1, body2);
  for (int i = 0; i < 3; ++i) out.bias[i] = rate * gap[i];
  for (int i = 0; i < 2; ++i) out.bias[3 + i] = rate * tilt[i];
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
  for (int j = 0; j < 3; ++j) {  // the gap's rate by an impulse of 1 along axis j
    const Triple<real> along{real(j == 0), real(j == 1), real(j == 2)};
    const Triple<real> gap = cross(hinge.I1 * cross(hinge.r1, along), hinge.r1) +
                             cross(hinge.I2 * cross(hinge.r2, along), hinge.r2);
    K[0][j] = gap.x, K[1][j] = gap.y, K[2][j] = gap.z;
    K[j][j] += inverse_mass1 + inverse_mass2;  // Eq. 7-3
  }
  for (int j = 0; j < 2; ++j) {  // the rates of gap and tilt by an impulse of 1 of axis row j
    const Triple<real> w1 = hinge.I1 * row[j], w2 = hinge.I2 * row[j];
    const Triple<real> gap = cross(hinge.r1, w1) + cross(hinge.r2, w2);
    K[0][3 + j] = K[3 + j][0] = -gap.x;
    K[1][3 + j] = K[3 + j][1] = -gap.y;
    K[2][3 + j] = K[3 + j][2] = -gap.z;
    for (int i = 0; i < 2; ++i) K[3 + i][3 + j] = dot(row[i], w1 + w2);
  }
  // end [exercise 7.2]
  return K;
}

// ---- graph colouring ---------------------------------------------------------------------------

std::vector<int> colours_of(const std::vector<BodyPair>& links, const std::vector<bool>& moves) {
  // begin [exercise 7.3]
  // For each body store the colours that its joints have so far, for example as
  // taken[body][colour]. Each joint in turn takes the lowest colour that is free at both its
  // bodies. A static body blocks no colour; its joints still get one.
  std::vector<std::vector<bool>> taken(moves.size());
  std::vector<int> colours;
  for (const BodyPair& link : links) {
    std::size_t colour = 0;
    const auto is_taken = [&](int body) {
      return moves[body] && colour < taken[body].size() && taken[body][colour];
    };
    while (is_taken(link.body1) || is_taken(link.body2)) ++colour;
    for (const int body : {link.body1, link.body2}) {
      if (taken[body].size() <= colour) taken[body].resize(colour + 1);
      taken[body][colour] = true;
    }
    colours.push_back(int(colour));
  }
  return colours;
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
  const Triple<Number> gap =  // its rate
      body2.v + cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1);
  const Triple<Number> turning = body2.w - body1.w;
  const Number e[] = {hinge.bias[0] + gap.x, hinge.bias[1] + gap.y, hinge.bias[2] + gap.z,
                      hinge.bias[3] + dot(hinge.axis_row[0], turning),
                      hinge.bias[4] + dot(hinge.axis_row[1], turning)};
  Number back[5];  // -lambda
  hinge.inverse_K_times(e, back);
  const Triple<Number> push{-back[0], -back[1], -back[2]};
  const Triple<Number> couple = -back[3] * hinge.axis_row[0] - back[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);  // Eq. 7-6
  // end [exercise 7.4]
}

template void solve(const HingeNumbers<real>&, Velocities<real>&, Velocities<real>&);
#ifndef JOINTS_REAL_HEADER
template void solve(const HingeNumbers<Lanes>&, Velocities<Lanes>&, Velocities<Lanes>&);
#endif

}  // namespace joints
