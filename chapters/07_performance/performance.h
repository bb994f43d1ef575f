// Chapter 7: the performance loop. The functions of performance.cpp. Read README.md beside it
// first. There is nothing to edit here.
#pragma once

#include <array>
#include <vector>

#include "chapters/02_ball/ball.h"
#include "chapters/03_hinge/hinge.h"
#include "engine/simd/body_pair.h"
#include "engine/simd/triple.h"

/// \defgroup chapter7 Chapter 7: the performance loop
/// \brief The work inside the loop, and how eight joints are solved in the time of one.
/// @{
namespace joints {

/// The geometry of a hinge: the point of chapter 2 and the axis of chapter 3.
struct Hinge {
  Point point;            ///< three rows
  Axis axis;              ///< two rows
  real beta = real(0.2);  ///< fraction of the error fed back per step [1]
};

/// All numbers of a hinge that the iterations of a step read. Number is `real` for one hinge, or a
/// lane type for several hinges side by side, one per lane.
template <class Number>
struct HingeNumbers {
  Triple<Number> r1, r2;  ///< levers from the centres to the anchors [m], world
  /// b x a1 and c x a1, Eq. 3-4: the factors of w2; those of w1 are their negatives [1].
  std::array<Triple<Number>, 2> axis_row;
  Symmetric<Number> I1, I2;          ///< inverse inertia [1/(kg m^2)], world
  std::array<Number, 5> bias;        ///< beta C / h: of the point [m/s], of the axis [rad/s]
  std::array<Number, 15> inverse_K;  ///< upper triangle of K^-1, indexed by place()

  /// The index of row i, column j in inverse_K, 0 to 14.
  static constexpr int place(int i, int j) {
    const int low = i < j ? i : j, high = i < j ? j : i;
    return low * (9 - low) / 2 + high;
  }
  /// out = K^-1 e, row by row; K^-1 is symmetric.
  void inverse_K_times(const Number* e, Number* out) const {
    const Number* k = inverse_K.data();
    out[0] = k[0] * e[0] + k[1] * e[1] + k[2] * e[2] + k[3] * e[3] + k[4] * e[4];
    out[1] = k[1] * e[0] + k[5] * e[1] + k[6] * e[2] + k[7] * e[3] + k[8] * e[4];
    out[2] = k[2] * e[0] + k[6] * e[1] + k[9] * e[2] + k[10] * e[3] + k[11] * e[4];
    out[3] = k[3] * e[0] + k[7] * e[1] + k[10] * e[2] + k[12] * e[3] + k[13] * e[4];
    out[4] = k[4] * e[0] + k[8] * e[1] + k[11] * e[2] + k[13] * e[3] + k[14] * e[4];
  }
};

/// Exercise 7.1: computes the numbers that a hinge's iterations read and that do not depend on the
/// velocities. Does not change inverse_K. \param h the step [s]
void hoist(const Hinge& hinge, const Body& body1, const Body& body2, real h,
           HingeNumbers<real>& out);

/// Exercise 7.2: K of the hinge's five rows as one block, in closed form: the upper left 3x3 block
/// [1/kg], the lower right 2x2 block [1/(kg m^2)] and the cross terms between them [1/(kg m)].
/// \param hinge its levers, axis rows and inverse inertias \param inverse_mass1 of body 1 [1/kg]
/// \param inverse_mass2 of body 2 [1/kg]
Matrix<5> whole_K(const HingeNumbers<real>& hinge, real inverse_mass1, real inverse_mass2);

/// Exercise 7.3: a colour for every joint, such that no two joints of one colour have a common
/// movable body. Each joint, from the first to the last, takes the lowest colour that is free at
/// both of its bodies; a static body blocks none. \param links the bodies of each joint
/// \param moves for each body, whether it can move
/// \return colours, counted from 0
std::vector<int> colours_of(const std::vector<BodyPair>& links, const std::vector<bool>& moves);

/// Exercise 7.4: one solve of the whole block. The velocities change so that all five rows are
/// satisfied. Written once; Number is `real` or a lane type.
template <class Number>
void solve(const HingeNumbers<Number>& hinge, Velocities<Number>& body1,
           Velocities<Number>& body2);

}  // namespace joints
/// @}
