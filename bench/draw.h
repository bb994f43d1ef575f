// Random numbers that are the same on every machine.
#pragma once

#include <cmath>
#include <random>

#include "engine/matrix.h"

/// \addtogroup bench
/// @{
namespace joints::bench {

/// Uniform numbers from the Mersenne twister itself: the standard's distributions differ between
/// libraries.
class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}
  double number(double from, double to) {
    return from + (to - from) * double(random_()) / 4294967296.0;
  }
  /// Uniform in its logarithm.
  double scale(double from, double to) {
    return std::exp(number(std::log(from), std::log(to)));
  }
  /// One of `from` to `to`, both included.
  int whole(int from, int to) { return from + int(number(0, to - from + 1)); }
  bool chance(double share) { return number(0, 1) < share; }
  vec3 direction() {
    for (;;) {
      const vec3 a(real(number(-1, 1)), real(number(-1, 1)), real(number(-1, 1)));
      if (length(a) > real(0.1) && length(a) < 1) return normalize(a);
    }
  }
  /// Any orientation.
  quat rotation() { return joints::rotation(real(number(0, 3.14)) * direction()); }

 private:
  std::mt19937 random_;
};

}  // namespace joints::bench
/// @}
