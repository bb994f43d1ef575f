// 3-vectors, inertias and velocities of a scalar or of a SIMD lane type, which GLM's do not allow.
#pragma once

#include "engine/real.h"

/// \addtogroup numbers
/// @{
namespace joints {

/// A 3-vector, or one per lane. Used like a vec3.
template <class Number>
struct Triple {
  Number x, y, z;  ///< its components
};

/// The sum.
template <class Number>
inline Triple<Number> operator+(const Triple<Number>& a, const Triple<Number>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
/// The difference.
template <class Number>
inline Triple<Number> operator-(const Triple<Number>& a, const Triple<Number>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
/// Adds.
template <class Number>
inline Triple<Number>& operator+=(Triple<Number>& a, const Triple<Number>& b) {
  return a = a + b;
}
/// Subtracts.
template <class Number>
inline Triple<Number>& operator-=(Triple<Number>& a, const Triple<Number>& b) {
  return a = a - b;
}
/// The negative.
template <class Number>
inline Triple<Number> operator-(const Triple<Number>& a) {
  return {-a.x, -a.y, -a.z};
}
/// A number times a vector.
template <class Number>
inline Triple<Number> operator*(const Number& factor, const Triple<Number>& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}
/// The dot product.
template <class Number>
inline Number dot(const Triple<Number>& a, const Triple<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// The cross product.
template <class Number>
inline Triple<Number> cross(const Triple<Number>& a, const Triple<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// From a vec3.
inline Triple<real> triple(const vec3& a) { return {a.x, a.y, a.z}; }

/// A symmetric 3x3 matrix, such as an inverse inertia in world axes: six numbers instead of nine.
template <class Number>
struct Symmetric {
  Number xx, yy, zz, xy, xz, yz;  ///< the diagonal, then the off-diagonal entries
};

/// Matrix times vector.
template <class Number>
[[gnu::always_inline]] inline Triple<Number> operator*(const Symmetric<Number>& m,
                                                       const Triple<Number>& a) {
  return {m.xx * a.x + m.xy * a.y + m.xz * a.z, m.xy * a.x + m.yy * a.y + m.yz * a.z,
          m.xz * a.x + m.yz * a.y + m.zz * a.z};
}
/// From a mat3 that is symmetric.
inline Symmetric<real> symmetric(const mat3& m) {
  return {m[0][0], m[1][1], m[2][2], m[1][0], m[2][0], m[2][1]};
}

constexpr int lane_count = 32 / int(sizeof(real));  ///< 8 in float, 4 in double

/// What an iteration reads and writes of a body: a record of eight numbers, or one per lane.
template <class Number>
struct alignas(32) Velocities {
  Triple<Number> v;     ///< of the centre [m/s], world
  Number inverse_mass;  ///< [1/kg], 0 for a static body
  Triple<Number> w;     ///< angular velocity [rad/s], world
  Number unused;        ///< padding
};

}  // namespace joints
/// @}
