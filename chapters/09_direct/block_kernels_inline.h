// The kernels of block_kernels.h. Given, there is nothing to edit here.
#pragma once

#include "chapters/09_direct/block_kernels.h"
#include "engine/kernels.h"

namespace joints {

/// \cond
// inverse(pivot, original); for two lanes, lane by lane.
template <class PivotInverse>
inline double inverse_of(double pivot, double original, PivotInverse inverse) {
  return inverse(pivot, original);
}
template <class PivotInverse>
inline TwoLanes inverse_of(const TwoLanes& pivot, const TwoLanes& original, PivotInverse inverse) {
  return TwoLanes{inverse(pivot[0], original[0]), inverse(pivot[1], original[1])};
}

template <class Number, class PivotInverse>
inline void factor_block(Number* D, int n, const Number* original, PivotInverse inverse) {
  with_size(n, [&](auto N) {
    for (int j = 0; j < N; ++j) {
      const Number over = inverse_of(D[j * N + j], original[j], inverse);
      for (int i = j + 1; i < N; ++i) {
        const Number l = D[i * N + j] * over;
        for (int k = i; k < N; ++k) D[k * N + i] -= l * D[k * N + j];
      }
      for (int i = j + 1; i < N; ++i) D[i * N + j] *= over;
      D[j * N + j] = over;
    }
  });
}

// x = D^-1 from, for a size known at compile time; the copy y can stay in registers.
template <int N, class Number>
inline void divide_by(const Number* D, const Number* from, Number* x) {
  Number y[N];
  for (int i = 0; i < N; ++i) {
    y[i] = from[i];
    for (int k = 0; k < i; ++k) y[i] -= D[i * N + k] * y[k];
  }
  for (int i = N - 1; i >= 0; --i) {
    y[i] *= D[i * N + i];
    for (int k = i + 1; k < N; ++k) y[i] -= D[k * N + i] * y[k];
  }
  for (int i = 0; i < N; ++i) x[i] = y[i];
}

template <class Number>
inline void divide(const Number* D, int n, Number* x) {
  with_size(n, [&](auto N) { divide_by<N>(D, x, x); });
}

template <class Number>
inline void divide_rows(const Number* A, int m, const Number* D, int n, Number* B) {
  with_size(n, [&](auto N) {
    for (int i = 0; i < m; ++i) divide_by<N>(D, A + i * N, B + i * N);
  });
}

template <class Number>
inline void subtract_product(const Number* A, int m, const Number* B, int p, int n, Number* C) {
  with_size(n, [&](auto N) {
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < p; ++j) {
        Number sum = A[i * N] * B[j * N];
        for (int k = 1; k < N; ++k) sum += A[i * N + k] * B[j * N + k];
        C[i * p + j] -= sum;
      }
  });
}

template <class Number>
inline void subtract_times(const Number* A, int m, int n, const Number* x, Number* y) {
  with_size(n, [&](auto N) {
    for (int i = 0; i < m; ++i)
      for (int k = 0; k < N; ++k) y[i] -= A[i * N + k] * x[k];
  });
}

template <class Number>
inline void subtract_transposed_times(const Number* A, int m, int n, const Number* x, Number* y) {
  with_size(n, [&](auto N) {
    for (int i = 0; i < m; ++i)
      for (int k = 0; k < N; ++k) y[k] -= A[i * N + k] * x[i];
  });
}
/// \endcond

}  // namespace joints
