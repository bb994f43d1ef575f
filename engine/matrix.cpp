// K of a block, and its inverse by symmetric Gauss-Jordan pivots (Goodnight 1979).
#include "engine/matrix.h"

#include <utility>

namespace joints {

namespace {

// Calls f(0) to f(n - 1) with compile-time constants: the loop is unrolled, and the entries below
// can stay in registers.
template <int n, class F>
void unrolled(const F& f) {
  [&]<int... k>(std::integer_sequence<int, k...>) {
    (f(std::integral_constant<int, k>{}), ...);
  }(std::make_integer_sequence<int, n>{});
}

// Pivot k solves row k for its unknown and substitutes it into all other rows. After the last pivot
// the lower triangle holds minus the inverse.
template <int N>
void invert(real* K) {
  real lower[N * (N + 1) / 2], original[N];
  bool dependent[N] = {}, any_dependent = false;
  const auto at = [&](int i, int j) -> real& {
    return i >= j ? lower[i * (i + 1) / 2 + j] : lower[j * (j + 1) / 2 + i];
  };
  unrolled<N>([&](auto i) {
    unrolled<i + 1>([&](auto j) { at(i, j) = K[i * N + j]; });
    original[i] = at(i, i);
  });
  unrolled<N>([&](auto k) {
    const real pivot = at(k, k);
    // What is left of a dependent row is rounding error; of a row that is zero, 0.
    if (!(pivot > 4 * epsilon * original[k])) {
      dependent[k] = any_dependent = true;
      return;
    }
    const real over_pivot = 1 / pivot;
    unrolled<N>([&](auto i) {
      if constexpr (i != k) {
        const real factor = at(i, k) * over_pivot;
        unrolled<i + 1>([&](auto j) {
          if constexpr (j != k) at(i, j) -= factor * at(j, k);
        });
      }
    });
    unrolled<N>([&](auto i) {
      if constexpr (i != k) at(i, k) *= over_pivot;
    });
    at(k, k) = -over_pivot;
  });
  unrolled<N>([&](auto i) {
    unrolled<i + 1>([&](auto j) { K[i * N + j] = K[j * N + i] = -at(i, j); });
  });
  if (!any_dependent) return;
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j)
      if (dependent[i] || dependent[j]) K[i * N + j] = 0;
}

}  // namespace

void form_responses(const Row* J, int n, const Body& body1, const Body& body2, Row* response) {
  const mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2);
  for (int i = 0; i < n; ++i)
    response[i] = {body1.inverse_mass * J[i].v1, I1 * J[i].w1, body2.inverse_mass * J[i].v2,
                   I2 * J[i].w2};
}

void form_K(const Row* J, const Row* response, int n, real* K) {
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j)
      K[i * n + j] = K[j * n + i] =
          dot(J[i].v1, response[j].v1) + dot(J[i].w1, response[j].w1) +
          dot(J[i].v2, response[j].v2) + dot(J[i].w2, response[j].w2);
}

void invert_symmetric(real* K, int n) {
  switch (n) {
    case 1: return invert<1>(K);
    case 2: return invert<2>(K);
    case 3: return invert<3>(K);
    case 4: return invert<4>(K);
    case 5: return invert<5>(K);
    case 6: return invert<6>(K);
  }
}

}  // namespace joints
