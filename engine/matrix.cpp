// The inverse of a small symmetric matrix by the sweep operator (Goodnight 1979).
#include "engine/matrix.h"

namespace joints {

// Sweeping pivot k solves row k for its unknown and puts the result into all the other rows; once
// every pivot has been swept, the inverse stands in the matrix' place, with its sign turned.
void invert_symmetric(real* K, int n) {
  const auto at = [&](int row, int column) -> real& { return K[row * n + column]; };
  real original[6];
  bool swept[6] = {};
  for (int k = 0; k < n; ++k) original[k] = at(k, k);

  for (int k = 0; k < n; ++k) {
    const real pivot = at(k, k);
    if (!(pivot > 4 * epsilon * original[k])) continue;  // a dependent row, or no mass at all:
    // what is left of it is the rounding of the sweeps before, a few epsilon
    swept[k] = true;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        if (i != k && j != k) at(i, j) -= at(i, k) * at(k, j) / pivot;
    for (int i = 0; i < n; ++i)
      if (i != k) at(i, k) = at(k, i) = at(i, k) / pivot;
    at(k, k) = -1 / pivot;
  }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      at(i, j) = swept[i] && swept[j] ? -at(i, j) : real(0);
}

}  // namespace joints
