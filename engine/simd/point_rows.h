// Three rows of a point and N - 3 angular rows, as in a ball, a hinge or a weld, with or without a
// limit: the three functions that every kind of rows has. Number is one number or one per lane, so
// every formula is that of one block.
//   form_K   J M^-1 J^T, lower triangle
//   errors   bias + J V
//   apply    V += M^-1 J^T lambda
#pragma once

#include "engine/simd/lanes.h"

/// \addtogroup world
/// @{
namespace joints {
/// \cond

// K += skew(r) I skew(r)^T, of one body.
template <class Number>
inline void add_lever(Number* K, const Triple<Number>& r, const Number& I) {
  const Triple<Number> Ir = I * r;
  const Number xx = Ir.x * r.x, yy = Ir.y * r.y, zz = Ir.z * r.z;
  K[0] += yy + zz;
  K[1] -= Ir.x * r.y;
  K[2] += xx + zz;
  K[3] -= Ir.x * r.z;
  K[4] -= Ir.y * r.z;
  K[5] += xx + yy;
}
template <class Number>
inline void add_lever(Number* K, const Triple<Number>& r, const Symmetric<Number>& I) {
  const Triple<Number> x{I.xx, I.xy, I.xz}, y{I.xy, I.yy, I.yz}, z{I.xz, I.yz, I.zz};
  const Triple<Number> a = r.z * y - r.y * z, b = r.x * z - r.z * x, c = r.y * x - r.x * y;
  K[0] += r.z * a.y - r.y * a.z;  // a, b, c are I (r x e) with the three unit vectors e
  K[1] += r.x * a.z - r.z * a.x;
  K[2] += r.x * b.z - r.z * b.x;
  K[3] += r.y * a.x - r.x * a.y;
  K[4] += r.y * b.x - r.x * b.y;
  K[5] += r.y * c.x - r.x * c.y;
}

// The inverse mass of both bodies. In an unused lane all numbers of the record are zero, but its
// columns may contain two bodies that no block connects. There it returns 0, so K^-1 is zero, too.
template <class Number>
inline Number used_mass(const Number& mass, const Number& I1, const Number& I2) {
  return where_above(I1 + I2, Number::of(0), mass);
}
template <class Number>
inline Number used_mass(const Number& mass, const Symmetric<Number>& I1,
                        const Symmetric<Number>& I2) {
  return used_mass(mass, I1.xx, I2.xx);
}

template <BlockKind kind, class Number, int N = kind.rows>
inline void form_K(const PointRows<kind, Number>& rows, const Velocities<Number>& body1,
                   const Velocities<Number>& body2, Number* K) {
  K[0] = K[2] = K[5] = used_mass(body1.inverse_mass + body2.inverse_mass, rows.I1, rows.I2);
  K[1] = K[3] = K[4] = Number::of(0);
  add_lever(K, rows.r1, rows.I1);
  add_lever(K, rows.r2, rows.I2);
  for (int i = 3; i < N; ++i) {
    const Triple<Number> w1 = rows.I1 * rows.axis[i - 3], w2 = rows.I2 * rows.axis[i - 3];
    const Triple<Number> gap = cross(w1, rows.r1) + cross(w2, rows.r2), turning = w1 + w2;
    Number* const row = K + lower_index(i, 0);
    row[0] = gap.x, row[1] = gap.y, row[2] = gap.z;
    for (int j = 3; j <= i; ++j) row[j] = dot(rows.axis[j - 3], turning);
  }
}

template <BlockKind kind, class Number, int N = kind.rows>
inline void errors(const PointRows<kind, Number>& rows, const Velocities<Number>& body1,
                   const Velocities<Number>& body2, Number* e) {
  const Triple<Number> v =
      body2.v + cross(body2.w, rows.r2) - body1.v - cross(body1.w, rows.r1);
  const Triple<Number> w = body2.w - body1.w;
  e[0] = rows.bias[0] + v.x, e[1] = rows.bias[1] + v.y, e[2] = rows.bias[2] + v.z;
  for (int i = 3; i < N; ++i) e[i] = rows.bias[i] + dot(rows.axis[i - 3], w);
}

template <BlockKind kind, class Number, int N = kind.rows>
inline void apply(const PointRows<kind, Number>& rows, const Number* lambda,
                  Velocities<Number>& body1, Velocities<Number>& body2) {
  const Triple<Number> P{lambda[0], lambda[1], lambda[2]};
  Triple<Number> L1 = cross(rows.r1, P), L2 = cross(rows.r2, P);  // angular impulses
  for (int i = 3; i < N; ++i) {
    const Triple<Number> couple = lambda[i] * rows.axis[i - 3];
    L1 = L1 + couple;
    L2 = L2 + couple;
  }
  body1.v = body1.v - body1.inverse_mass * P;
  body1.w = body1.w - rows.I1 * L1;
  body2.v = body2.v + body2.inverse_mass * P;
  body2.w = body2.w + rows.I2 * L2;
}

/// \endcond
}  // namespace joints
/// @}
