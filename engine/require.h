// The functions that reject invalid input, each with a sentence that says what is wrong.
#pragma once

#include <string>

#include "engine/real.h"

/// \addtogroup numbers
/// @{
namespace joints {

/// Rejects invalid input. Every std::invalid_argument of the engine and the joints is thrown here.
/// \param what one sentence with the argument and the condition that it must satisfy
/// \throws std::invalid_argument always
[[noreturn]] void refuse(const std::string& what);

/// Rejects a value, as in "beta is -1; must be between 0 and 10 [1]". \param what its name
/// \param must the condition that it must satisfy, in words \throws std::invalid_argument always
[[noreturn]] void refuse(const char* what, real value, const char* must);
/// The same for three numbers.
[[noreturn]] void refuse(const char* what, const vec3& value, const char* must);
/// The same for four numbers, (w, x, y, z).
[[noreturn]] void refuse(const char* what, const quat& value, const char* must);

/// Calls refuse(what) unless `good`.
inline void require(bool good, const char* what) {
  if (!good) refuse(what);
}
/// Calls refuse(what, value, must) unless `good`.
template <class Value>
void require(bool good, const char* what, const Value& value, const char* must) {
  if (!good) refuse(what, value, must);
}
/// Rejects a value with a number that is NaN or infinite.
template <class Value>
void require_finite(const char* what, const Value& value, const char* must = "must be finite") {
  require(finite(value), what, value, must);
}
/// Rejects a direction or quaternion whose length is not 1.
template <class Value>
void require_unit(const char* what, const Value& value) {
  require(is_unit(value), what, value, "must have the length 1");
}

}  // namespace joints
/// @}
