// Small dense blocks of 1 to 6 rows: the arithmetic of the factorisation. Given, there is nothing
// to edit here.
#pragma once

#include <utility>

/// \addtogroup chapter9
/// @{
namespace joints {

/// \cond
// Calls f with n as a compile-time constant: loops over blocks are unrolled.
template <class F>
inline void with_size(int n, const F& f) {
  switch (n) {
    case 1: return f(std::integral_constant<int, 1>{});
    case 2: return f(std::integral_constant<int, 2>{});
    case 3: return f(std::integral_constant<int, 3>{});
    case 4: return f(std::integral_constant<int, 4>{});
    case 5: return f(std::integral_constant<int, 5>{});
    case 6: return f(std::integral_constant<int, 6>{});
  }
}
/// \endcond

/// D = L d L^T in place, of the lower triangle of a symmetric n x n block. Below the diagonal stays
/// L, whose own diagonal is 1; on it stays inverse(d, original).
template <class PivotInverse>
inline void factor_block(double* D, int n, const double* original, PivotInverse inverse) {
  with_size(n, [&](auto N) {
    for (int j = 0; j < N; ++j) {
      const double over = inverse(D[j * N + j], original[j]);
      for (int i = j + 1; i < N; ++i) {
        const double l = D[i * N + j] * over;
        for (int k = i; k < N; ++k) D[k * N + i] -= l * D[k * N + j];
      }
      for (int i = j + 1; i < N; ++i) D[i * N + j] *= over;
      D[j * N + j] = over;
    }
  });
}

/// x = D^-1 x, with the factor of the n x n block D.
inline void divide(const double* D, int n, double* x) {
  with_size(n, [&](auto N) {
    for (int i = 1; i < N; ++i)
      for (int k = 0; k < i; ++k) x[i] -= D[i * N + k] * x[k];
    for (int i = 0; i < N; ++i) x[i] *= D[i * N + i];
    for (int i = N - 2; i >= 0; --i)
      for (int k = i + 1; k < N; ++k) x[i] -= D[k * N + i] * x[k];
  });
}

/// B = A D^-1 for m x n numbers A, with the factor of the n x n block D.
inline void divide_rows(const double* A, int m, const double* D, int n, double* B) {
  for (int i = 0; i < m * n; ++i) B[i] = A[i];
  for (int i = 0; i < m; ++i) divide(D, n, B + i * n);
}

/// C -= A B^T, of m x n numbers A and p x n numbers B.
inline void subtract_product(const double* A, int m, const double* B, int p, int n, double* C) {
  with_size(n, [&](auto N) {
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < p; ++j) {
        double sum = 0;
        for (int k = 0; k < N; ++k) sum += A[i * N + k] * B[j * N + k];
        C[i * p + j] -= sum;
      }
  });
}

/// y -= A x, of m x n numbers A.
inline void subtract_times(const double* A, int m, int n, const double* x, double* y) {
  with_size(n, [&](auto N) {
    for (int i = 0; i < m; ++i)
      for (int k = 0; k < N; ++k) y[i] -= A[i * N + k] * x[k];
  });
}

/// y -= A^T x, of m x n numbers A.
inline void subtract_transposed_times(const double* A, int m, int n, const double* x, double* y) {
  with_size(n, [&](auto N) {
    for (int i = 0; i < m; ++i)
      for (int k = 0; k < N; ++k) y[k] -= A[i * N + k] * x[i];
  });
}

}  // namespace joints
/// @}
