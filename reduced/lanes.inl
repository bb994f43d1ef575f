// The recursion of chapter 11 on lanes: the same functions, compiled for numbers that are those of
// lane_count trees side by side. Each file that is compiled for an instruction set includes it; as
// all is in an unnamed namespace, the linker cannot merge them.
#pragma once

#include <utility>

#include "engine/kernels.h"
#include "engine/simd/triple.h"
#include "engine/instruments/todo.h"
#include "reduced/recursion.inl"

namespace joints {
/// \cond
namespace {
namespace on_lanes {

typedef real Vector __attribute__((vector_size(32), may_alias));

// Used like a number. A comparison is true if it is in all lanes.
struct Lanes {
  Vector all;

  Lanes() = default;
  JOINTS_INLINED Lanes(real a) : all(a + Vector{}) {}
  JOINTS_INLINED Lanes(Vector all, int) : all(all) {}
  friend JOINTS_INLINED Lanes operator+(Lanes a) { return a; }
  friend JOINTS_INLINED Lanes operator-(Lanes a) { return {-a.all, 0}; }
  friend JOINTS_INLINED Lanes operator+(Lanes a, Lanes b) { return {a.all + b.all, 0}; }
  friend JOINTS_INLINED Lanes operator-(Lanes a, Lanes b) { return {a.all - b.all, 0}; }
  friend JOINTS_INLINED Lanes operator*(Lanes a, Lanes b) { return {a.all * b.all, 0}; }
  friend JOINTS_INLINED Lanes operator/(Lanes a, Lanes b) { return {a.all / b.all, 0}; }
  JOINTS_INLINED Lanes& operator+=(Lanes b) { return *this = *this + b; }
  JOINTS_INLINED Lanes& operator-=(Lanes b) { return *this = *this - b; }
  JOINTS_INLINED Lanes& operator*=(Lanes b) { return *this = *this * b; }
  JOINTS_INLINED Lanes& operator/=(Lanes b) { return *this = *this / b; }
  friend bool operator>(Lanes a, Lanes b) {
    for (int k = 0; k < lane_count; ++k)
      if (!(a.all[k] > b.all[k])) return false;
    return true;
  }
  friend bool operator<=(Lanes a, Lanes b) { return !(a > b); }
  // The same function of each lane. (Not as a loop: so the compiler sees sine and cosine as one.)
  friend JOINTS_INLINED Lanes each(auto f, Lanes a) {
    return [&]<int... k>(std::integer_sequence<int, k...>) JOINTS_INLINED {
      return Lanes(Vector{f(a.all[k])...}, 0);
    }(std::make_integer_sequence<int, lane_count>());
  }
};
inline Lanes sin(Lanes a) { return each([](real x) { return std::sin(x); }, a); }
inline Lanes cos(Lanes a) { return each([](real x) { return std::cos(x); }, a); }

}  // namespace on_lanes
}  // namespace
/// \endcond
}  // namespace joints

namespace std {
using joints::on_lanes::sin, joints::on_lanes::cos;
template <>
struct numeric_limits<joints::on_lanes::Lanes> : numeric_limits<joints::real> {};
}  // namespace std

namespace joints {
/// \cond
namespace {
namespace on_lanes {

// What chapter 11's file names, on lanes.
using real = Lanes;
using vec3 = glm::vec<3, Lanes>;
using mat3 = glm::mat<3, 3, Lanes>;
using quat = glm::qua<Lanes>;
using TreeLink = TreeLinkOf<Lanes>;
inline mat3 skew(const vec3& r) { return mat3(0, r.z, -r.y, -r.z, 0, r.x, r.y, -r.x, 0); }
inline mat3 crossed(const vec3& d, const mat3& A) {
  return mat3(cross(d, A[0]), cross(d, A[1]), cross(d, A[2]));
}
inline quat normalize(const quat& q) {
  return q * (Lanes(1) / each([](::joints::real x) { return std::sqrt(x); }, dot(q, q)));
}
inline namespace joints {
mat3 inverse_of(const mat3& A);
[[maybe_unused]] void locate(TreeLink& link, const TreeLink& parent);
}
#include "solutions/11_reduced/reduced.cpp"

// A Runge-Kutta step of all links. Their inertias begin with the place.
[[gnu::flatten]] inline void runge_kutta(TreeLink* first, int count, StateOf<TreeLink>* base,
                                         StateOf<TreeLink>* sum, ::joints::real h) {
  TreeLink* const end = first + count;
  for (int k = 0; k < count; ++k) base[k] = state_of(first[k]);
  for (int stage = 0; stage < 4; ++stage) {
    place_links(first, end);
    accelerate_links(first, end, true, true);
    for (int k = 0; k < count; ++k) advance(first[k], base[k], sum[k], stage, h);
  }
}

}  // namespace on_lanes
}  // namespace
/// \endcond
}  // namespace joints
