// The inverse of a small symmetric matrix by the sweep operator (Goodnight 1979).
#include "engine/matrix.h"

namespace joints {

namespace {

// Sweeping pivot k solves row k for its unknown and puts the result into all the other rows; once
// every pivot has been swept, the inverse stands in the matrix' place, with its sign turned. Works
// on the lower half; N is known to the compiler, which leaves no loop.
template <int N>
void invert(real* K) {
  real original[N];
  bool swept[N] = {};
  for (int k = 0; k < N; ++k) original[k] = K[k * N + k];
  const auto at = [&](int i, int j) -> real& { return i >= j ? K[i * N + j] : K[j * N + i]; };

  for (int k = 0; k < N; ++k) {
    const real pivot = at(k, k);
    if (!(pivot > 4 * epsilon * original[k])) continue;  // a dependent row, or no mass at all:
    // what is left of it is the rounding of the sweeps before, a few epsilon
    swept[k] = true;
    const real over_pivot = 1 / pivot;
    for (int i = 0; i < N; ++i) {
      if (i == k) continue;
      const real factor = at(i, k) * over_pivot;
      for (int j = 0; j <= i; ++j)
        if (j != k) at(i, j) -= factor * at(j, k);
    }
    for (int i = 0; i < N; ++i)
      if (i != k) at(i, k) *= over_pivot;
    at(k, k) = -over_pivot;
  }
  for (int i = 0; i < N; ++i)
    for (int j = 0; j <= i; ++j)
      K[i * N + j] = K[j * N + i] = swept[i] && swept[j] ? -at(i, j) : real(0);
}

}  // namespace

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
