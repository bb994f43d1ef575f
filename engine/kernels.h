// The arithmetic of rows and small matrices that every solver repeats, written such that a compiler
// generates few instructions for it.
#pragma once

#include <utility>

#include "engine/matrix.h"

/// \addtogroup rows
/// @{
namespace joints {

/// \cond
// A register of 16 bytes: four floats, two doubles, or one number of a user-defined type. Without
// AVX, numbers in a wider register would go through memory.
#ifdef JOINTS_REAL_HEADER
typedef real Register;
inline real number(const Register& r, int) { return r; }
#else
typedef real Register __attribute__((vector_size(16), aligned(alignof(real)), may_alias));
inline real number(const Register& r, int k) { return r[k]; }
#endif
constexpr int register_size = int(sizeof(Register) / sizeof(real));
/// \endcond

/// \cond
#define JOINTS_INLINED __attribute__((always_inline))
/// \endcond
/// The twelve numbers of a row.
struct Twelve {
  Register part[12 / register_size];  ///< the numbers of v1, w1, v2 and w2, in this order
};
/// The numbers of a row, in place.
inline const Twelve& twelve(const Row& row) { return reinterpret_cast<const Twelve&>(row); }
/// J V of a row. \param V v and w of both bodies
JOINTS_INLINED inline real dot(const Twelve& J, const Twelve& V) {
  constexpr int parts = 4 / register_size;
  Register sums[parts];  // four, each of three products
  for (int k = 0; k < parts; ++k)
    sums[k] = J.part[k] * V.part[k] + J.part[k + parts] * V.part[k + parts] +
              J.part[k + 2 * parts] * V.part[k + 2 * parts];
  const auto at = [&](int k) { return number(sums[k / register_size], k % register_size); };
  return (at(0) + at(2)) + (at(1) + at(3));
}

/// 1 / a if a > least, else 0.
inline real inverse_above(real a, real least) { return a > least ? 1 / a : real(0); }

/// \cond
// Calls f(0) to f(n - 1) with compile-time constants, so that the loop is unrolled and the entries
// below can stay in registers.
template <int n, class F>
inline void unrolled(const F& f) {
  [&]<int... k>(std::integer_sequence<int, k...>) {
    (f(std::integral_constant<int, k>{}), ...);
  }(std::make_integer_sequence<int, n>{});
}
/// \endcond
/// Calls f with n, from 1 to 6, as a compile-time constant.
template <class F>
JOINTS_INLINED inline void with_size(int n, const F& f) {
  switch (n) {
    case 1: return f(std::integral_constant<int, 1>{});
    case 2: return f(std::integral_constant<int, 2>{});
    case 3: return f(std::integral_constant<int, 3>{});
    case 4: return f(std::integral_constant<int, 4>{});
    case 5: return f(std::integral_constant<int, 5>{});
    case 6: return f(std::integral_constant<int, 6>{});
  }
}

/// The index of row i and column j in the lower triangle of a symmetric matrix, row by row.
constexpr int lower_index(int i, int j) {
  return i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
}

/// invert_symmetric() for a matrix of known size, of which only the lower triangle is stored.
/// Number is real or a lane type. The method is symmetric Gauss-Jordan elimination (Goodnight
/// 1979): pivot k solves row k for its unknown and substitutes it into all other rows.
template <int N, class Number>
inline void invert_lower(Number* K) {
  const auto at = [&](int i, int j) -> Number& { return K[lower_index(i, j)]; };
  Number least[N];  // up to this a pivot is rounding error: its row depends on others
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
  unrolled<N*(N + 1) / 2>([&](auto k) { K[k] = -K[k]; });  // minus the inverse so far
}

}  // namespace joints
/// @}
