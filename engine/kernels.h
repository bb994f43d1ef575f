// The arithmetic that every solver does once for each row or block, in the form in which a compiler
// makes few instructions of it.
#pragma once

#include <utility>

#include "engine/matrix.h"

/// \addtogroup rows
/// @{
namespace joints {

#ifdef REAL_HEADER  // numbers of one's own kind go one by one
/// Four numbers side by side.
struct Four {
  real n[4];  ///< the numbers
  real operator[](int k) const { return n[k]; }  ///< one of them
  friend Four operator*(const Four& a, const Four& b) {
    return {{a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3]}};
  }
  friend Four operator+(const Four& a, const Four& b) {
    return {{a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]}};
  }
};
#else
/// Four numbers side by side.
typedef real Four
    __attribute__((vector_size(4 * sizeof(real)), aligned(alignof(real)), may_alias));
#endif
/// The sum of all four.
inline real sum(const Four& a) { return (a[0] + a[2]) + (a[1] + a[3]); }
/// The cosine of half the rotation between two orientations, of either sign.
inline real half_cosine(const quat& p, const quat& q) {
  return sum(reinterpret_cast<const Four&>(p) * reinterpret_cast<const Four&>(q));
}

/// The numbers of a row, in three registers.
struct Twelve {
  Four part[3];  ///< of v1, w1, v2 and w2, in this order
};
/// Where a row is stored.
inline const Twelve& twelve(const Row& row) { return reinterpret_cast<const Twelve&>(row); }
/// J V of a row.
inline real dot(const Twelve& J, const Twelve& V) {
  return sum(J.part[0] * V.part[0] + J.part[1] * V.part[1] + J.part[2] * V.part[2]);
}

/// 1 / a where a > least, else 0.
inline real inverse_above(real a, real least) { return a > least ? 1 / a : real(0); }

/// \cond
// Calls f(0) to f(n - 1) with compile-time constants: the loop is unrolled, and the entries below
// can stay in registers.
template <int n, class F>
inline void unrolled(const F& f) {
  [&]<int... k>(std::integer_sequence<int, k...>) {
    (f(std::integral_constant<int, k>{}), ...);
  }(std::make_integer_sequence<int, n>{});
}
/// \endcond

/// The index of row i and column j in the lower triangle of a symmetric matrix, row by row.
constexpr int lower_index(int i, int j) {
  return i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
}

/// invert_symmetric() for a matrix of known size, of which only the lower triangle is stored.
/// Number is real or a lane type. By symmetric Gauss-Jordan pivots (Goodnight 1979): pivot k solves
/// row k for its unknown and substitutes it into all other rows.
template <int N, class Number>
inline void invert_lower(Number* K) {
  const auto at = [&](int i, int j) -> Number& { return K[lower_index(i, j)]; };
  Number least[N];  // what is left of a dependent row is rounding error; of a row that is zero, 0
  unrolled<N>([&](auto i) { least[i] = (4 * epsilon) * at(i, i); });
  unrolled<N>([&](auto k) {
    const Number over_pivot = inverse_above(at(k, k), least[k]);  // 0: its row and column get 0
    unrolled<N>([&](auto i) {
      if constexpr (i != k) {
        const Number factor = at(i, k) * over_pivot;
        unrolled<i + 1>([&](auto j) {
          if constexpr (j != k) at(i, j) = at(i, j) - factor * at(j, k);
        });
      }
    });
    unrolled<N>([&](auto i) {
      if constexpr (i != k) at(i, k) = at(i, k) * over_pivot;
    });
    at(k, k) = -over_pivot;
  });
  unrolled<N*(N + 1) / 2>([&](auto k) { K[k] = -K[k]; });  // the pivots leave minus the inverse
}

}  // namespace joints
/// @}
