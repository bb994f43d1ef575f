// The kernels of block_kernels.h, for each number of rows a loop of known length.
#include "chapters/09_direct/block_kernels.h"

#include "engine/kernels.h"

namespace joints {

void factor_block(double* D, int n, const double* original, PivotInverse inverse) {
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

// x = D^-1 from, for a size known at compile time; the copy y can stay in registers.
template <int N>
static void divide_by(const double* D, const double* from, double* x) {
  double y[N];
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

void divide(const double* D, int n, double* x) {
  with_size(n, [&](auto N) { divide_by<N>(D, x, x); });
}

void divide_rows(const double* A, int m, const double* D, int n, double* B) {
  with_size(n, [&](auto N) {
    for (int i = 0; i < m; ++i) divide_by<N>(D, A + i * N, B + i * N);
  });
}

void subtract_product(const double* A, int m, const double* B, int p, int n, double* C) {
  with_size(n, [&](auto N) {
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < p; ++j) {
        double sum = A[i * N] * B[j * N];
        for (int k = 1; k < N; ++k) sum += A[i * N + k] * B[j * N + k];
        C[i * p + j] -= sum;
      }
  });
}

void subtract_times(const double* A, int m, int n, const double* x, double* y) {
  with_size(n, [&](auto N) {
    for (int i = 0; i < m; ++i) {
      double left = y[i];
      for (int k = 0; k < N; ++k) left -= A[i * N + k] * x[k];
      y[i] = left;
    }
  });
}

void subtract_transposed_times(const double* A, int m, int n, const double* x, double* y) {
  with_size(n, [&](auto N) {
    double left[N];
    for (int k = 0; k < N; ++k) left[k] = y[k];
    for (int i = 0; i < m; ++i)
      for (int k = 0; k < N; ++k) left[k] -= A[i * N + k] * x[i];
    for (int k = 0; k < N; ++k) y[k] = left[k];
  });
}

}  // namespace joints
