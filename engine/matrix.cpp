// K of a block, and its inverse by the sweep operator (Goodnight 1979).
#include "engine/matrix.h"

#include <utility>

namespace joints {

namespace {

// f(0), f(1), .. f(n - 1), each with a number that the compiler knows: no loop is left, and every
// entry below has a register of its own.
template <int n, class F>
void unrolled(const F& f) {
  [&]<int... k>(std::integer_sequence<int, k...>) {
    (f(std::integral_constant<int, k>{}), ...);
  }(std::make_integer_sequence<int, n>{});
}

// Sweeping pivot k solves row k for its unknown and puts the result into all the other rows; once
// every pivot has been swept, the inverse stands in the matrix' place, with its sign turned.
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
    if (!(pivot > 4 * epsilon * original[k])) {  // a dependent row, or no mass at all: what is
      dependent[k] = any_dependent = true;       // left of it is the rounding of the sweeps before
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
