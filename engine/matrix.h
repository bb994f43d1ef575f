// Rows of a Jacobian, and K = J M^-1 J^T and its inverse, for 1 to 6 rows.
#pragma once

#include <array>
#include <new>

#include "engine/body.h"

/// \defgroup rows Rows and blocks
/// \brief The Jacobian's rows, the matrix K, and the block: the complete input of a solver.
/// @{
namespace joints {

/// One row of a Jacobian: four 3-vectors in world space, the factors of v1, w1, v2 and w2 in dC/dt
/// [1 for v and m for w if C is in m; 1/m and 1 if C is in rad].
struct Row {
  vec3 v1{0};  ///< factor of the velocity of body 1's centre
  vec3 w1{0};  ///< factor of the angular velocity of body 1
  vec3 v2{0};  ///< factor of the velocity of body 2's centre
  vec3 w2{0};  ///< factor of the angular velocity of body 2
};

/// A column of N numbers.
template <int N>
using Vector = std::array<real, N>;

/// An N x N matrix: m[row][column].
template <int N>
struct Matrix {
  std::array<std::array<real, N>, N> m{};  ///< the entries, row by row
  std::array<real, N>& operator[](int row) { return m[row]; }  ///< one row
  const std::array<real, N>& operator[](int row) const { return m[row]; }  ///< one row
};

/// A Jacobian of N rows.
template <int N>
struct Jacobian {
  std::array<Row, N> row{};  ///< the rows
  Row& operator[](int i) { return row[i]; }  ///< row i
  const Row& operator[](int i) const { return row[i]; }  ///< row i
};

/// Three rows from the four 3x3 matrices of the formula J = ( v1  w1  v2  w2 ).
inline Jacobian<3> jacobian_from_blocks(const mat3& v1, const mat3& w1, const mat3& v2,
                                        const mat3& w2) {
  const mat3 a = transpose(v1), b = transpose(w1), c = transpose(v2), d = transpose(w2);
  const auto row = [&](int i) { return Row{a[i], b[i], c[i], d[i]}; };  // a[i]: row i of v1
  return {{row(0), row(1), row(2)}};
}

// The geometry of a joint is a part: error() returns its C and jacobian() its J
// (engine/parts/part.h).

/// What error() may return as an array: a scalar,
inline Vector<1> to_vector(real a) { return {a}; }
/// a 3-vector,
inline Vector<3> to_vector(const vec3& a) { return {a.x, a.y, a.z}; }
/// or already an array.
template <std::size_t N>
const std::array<real, N>& to_vector(const std::array<real, N>& a) { return a; }
/// What jacobian() may return as an array of rows: one row,
inline Jacobian<1> to_jacobian(const Row& row) { return {{row}}; }
/// or already an array.
template <int N>
const Jacobian<N>& to_jacobian(const Jacobian<N>& J) { return J; }

/// The form of a part's rows, known from its type. Solvers on lanes use a shorter formula for some.
enum class Form : signed char {
  any,      ///< nothing is known of the rows
  angular,  ///< v1 = v2 = 0 and w1 = -w2
  point     ///< three rows v1 = -E, w1 = skew(r1), v2 = E, w2 = -skew(r2), then angular rows
};

/// Writes C of a part to `C`. Composite (engine/parts), several parts as one, overloads this and
/// write_jacobian().
template <class P>
void write_error(const P& part, const Body& body1, const Body& body2, real* C) {
  const Vector<P::rows> error = to_vector(part.error(body1, body2));
  for (int i = 0; i < P::rows; ++i) C[i] = error[i];
}
/// Writes the rows of a part to `J`.
template <class P>
void write_jacobian(const P& part, const Body& body1, const Body& body2, Row* J) {
  using Rows = decltype(part.jacobian(body1, body2));  // Row or Jacobian
  static_assert(sizeof(Rows) == P::rows * sizeof(Row));
  ::new (J) Rows(part.jacobian(body1, body2));  // in place, without a copy
}

/// J V for one row: the rate [unit of C per s] at which the bodies' velocities change C.
inline real row_velocity(const Row& row, const Body& body1, const Body& body2) {
  return dot(row.v1, body1.v) + dot(row.w1, body1.w) + dot(row.v2, body2.v) +
         dot(row.w2, body2.w);
}

/// M^-1 J^T: the change of both bodies' velocities caused by an impulse of 1 along each of n rows.
void form_responses(const Row* J, int n, const Body& body1, const Body& body2, Row* response);

/// K = J (M^-1 J^T), the inverse effective mass of n rows that are solved together: n x n numbers,
/// row by row [1/kg, 1/(kg m) or 1/(kg m^2), depending on the units of the rows].
void form_K(const Row* J, const Row* response, int n, real* K);

/// Inverts a symmetric positive semidefinite matrix of n x n numbers (n from 1 to 6) in place.
/// If a pivot is at most 4 epsilon times its original diagonal entry, its row depends on the rows
/// before it. Then its row and column of the inverse are set to zero, so that it gets no impulse.
/// The threshold is relative, so masses and lengths may have any size.
void invert_symmetric(real* K, int n);

}  // namespace joints
/// @}
