// The scalar type, GLM's small vectors made of it, and the rejection of invalid ones.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <string>
#include <type_traits>

#ifndef JOINTS_REAL
#define JOINTS_REAL double
#endif
#ifdef JOINTS_REAL_HEADER  // declares a user-defined type; before GLM, which imports std::sqrt
#include JOINTS_REAL_HEADER
#endif
#if __cplusplus < 202002L
#error "the joints need C++20: compile with -std=c++20 or later"
#elif defined GLM_FORCE_QUAT_DATA_WXYZ
#error "GLM_FORCE_QUAT_DATA_WXYZ: the library keeps a quaternion as x, y, z, w"
#endif
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

/// \defgroup numbers Numbers and vectors
/// \brief The scalar type, GLM's small vectors made of it, and the rejection of invalid ones.
/// @{

/// The namespace of engine and chapters.
namespace joints {

/// The scalar type of the whole workbook. Every target is built with `JOINTS_REAL=double` and,
/// under a name that ends in `_float`, with `JOINTS_REAL=float`.
using real = JOINTS_REAL;

using vec3 = glm::vec<3, real, glm::defaultp>;     ///< a column of three numbers
using mat3 = glm::mat<3, 3, real, glm::defaultp>;  ///< 3x3, stored by columns: M[column][row]
using quat = glm::qua<real, glm::defaultp>;        ///< (w, x, y, z), rotates body space into world

/// A number of another type. GLM multiplies a vector by `real` alone; the deleted operators below
/// make the compiler say so.
template <class Number>
concept OtherNumber = std::is_arithmetic_v<Number> && !std::same_as<Number, real>;
template <OtherNumber N> vec3 operator*(N, const vec3&) = delete;  ///< write real(2) * v
template <OtherNumber N> vec3 operator*(const vec3&, N) = delete;  ///< write v * real(2)
template <OtherNumber N> vec3 operator/(const vec3&, N) = delete;  ///< write v / real(2)

// Two guards at link time, which a reader may skip.

/// GLM_FORCE_CTOR_INIT changes how GLM's vectors are copied and passed.
using GlmKind = std::conditional_t<std::is_trivially_copyable_v<vec3>, struct DefaultGlm,
                                   struct GlmWithCtorInit>;
/// A guard: a file in double does not link with the library in float, which lacks this function.
void number_of_the_library(real, GlmKind*);
[[gnu::used]] static void (*const this_library)(real, GlmKind*) = number_of_the_library;  ///< used

/// The distance from 1 to the next larger `real`.
inline constexpr real epsilon = std::numeric_limits<real>::epsilon();
/// A bound that has no effect.
inline constexpr real unbounded = std::numeric_limits<real>::infinity();

/// The matrix of a cross product: skew(r) a = r x a. Its transpose is its negative.
inline mat3 skew(const vec3& r) {
  return mat3(0, r.z, -r.y, -r.z, 0, r.x, r.y, -r.x, 0);  // column by column
}

/// True if it is neither infinite nor NaN. (A template, so that it does not clash with the C
/// library's finite(double).)
template <std::convertible_to<real> Number>
bool finite(const Number& a) { return std::isfinite(real(a)); }
/// True if all three entries are finite.
inline bool finite(const vec3& a) { return finite(a.x) && finite(a.y) && finite(a.z); }
/// True if all four entries are finite.
inline bool finite(const quat& q) {
  return finite(q.w) && finite(q.x) && finite(q.y) && finite(q.z);
}
/// The sum of all entries, which is finite only if each of them is: a fast test for valid input.
inline real sum(const vec3& a) { return a.x + a.y + a.z; }
/// The same for a quaternion.
inline real sum(const quat& q) { return q.w + q.x + q.y + q.z; }
/// True if the length of a vector or quaternion is 1 within 1e-6. A rotation by such a quaternion
/// misplaces a point 10 m away by at most 40 micrometres.
template <class Vector>
bool is_unit(const Vector& a) { return std::abs(dot(a, a) - 1) < real(2e-6); }

// ---- the rejection of invalid input -------------------------------------------------------------

/// Rejects invalid input. Every std::invalid_argument of core and joints is thrown here.
/// \param what one sentence with the argument and the condition that it must satisfy
/// \throws std::invalid_argument always
[[noreturn]] void refuse(const std::string& what);

/// Rejects a value, as in "beta is -1; must be between 0 and 10 [1]". \param what its name
/// \param must the condition that it must satisfy, in words \throws std::invalid_argument always
[[noreturn]] void refuse(const char* what, real value, const char* must);
[[noreturn]] void refuse(const char* what, const vec3& value, const char* must);  ///< (x, y, z)
[[noreturn]] void refuse(const char* what, const quat& value, const char* must);  ///< (w, x, y, z)

/// Calls refuse() unless `good`.
inline void require(bool good, const char* what) {
  if (!good) refuse(what);
}
/// The same with a value.
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
