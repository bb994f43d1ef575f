// The messages about invalid input.
#include "engine/real.h"

#include <cstdio>
#include <stdexcept>
#include <type_traits>

namespace joints {

void number_of_the_library(real, GlmKind*) {}

template <class Number>
static std::string text(Number a) {
  char digits[32] = "a number with a unit";  // tests/checker/quantity.h
  if constexpr (std::is_floating_point_v<Number>) {
    if (std::isnan(a)) return "nan";  // of either sign
    std::snprintf(digits, sizeof digits, "%.*g", std::numeric_limits<real>::digits10, double(a));
  }
  return digits;
}

void refuse(const std::string& what) { throw std::invalid_argument(what); }

void refuse(const char* what, real value, const char* must) {
  refuse(what + (" is " + text(value)) + "; " + must);
}
void refuse(const char* what, const vec3& a, const char* must) {
  refuse(what + (" is (" + text(a.x)) + ", " + text(a.y) + ", " + text(a.z) + "); " + must);
}
void refuse(const char* what, const quat& q, const char* must) {
  refuse(what + (" is (" + text(q.w)) + ", " + text(q.x) + ", " + text(q.y) + ", " + text(q.z) +
         "); " + must);
}

}  // namespace joints
