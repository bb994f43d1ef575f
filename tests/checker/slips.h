// What slips of the pen make of a number, a vector or a rotation (tools/check/slips.py).
// It compiles with each type: what does not fit stays as it was. With WORKBOOK_SLIPS_FIT that is
// an error.
#pragma once

#include <type_traits>
#include <utility>

#include "engine/real.h"

namespace joints::testing {

template <class T>
concept Scaled = !std::is_integral_v<std::remove_cvref_t<T>> &&
                 requires(const T& x) { real(2) * x; x * real(2); };
template <class T>
using Same = std::remove_cvref_t<T>;

#ifdef WORKBOOK_SLIPS_FIT
template <class T>
concept Kept = false;
#else
template <class T>
concept Kept = true;
#endif

template <class T>
decltype(auto) kept(auto&& x) {
  static_assert(Kept<T>);
  return std::forward<T>(x);
}

template <class T>
decltype(auto) times(real factor, T&& x) {
  if constexpr (Scaled<T>) return Same<T>(factor * x);
  else return kept<T>(x);
}
template <class T>
decltype(auto) minus(T&& x) { return times(-1, std::forward<T>(x)); }
template <class T>
decltype(auto) twice(T&& x) { return times(2, std::forward<T>(x)); }
template <class T>
decltype(auto) half(T&& x) { return times(real(0.5), std::forward<T>(x)); }
template <class T>
decltype(auto) size(T&& x) {
  if constexpr (std::is_floating_point_v<Same<T>> || std::is_same_v<Same<T>, vec3>)
    return Same<T>(glm::abs(x));
  else return kept<T>(x);
}
template <class T>
T above(const T& x, real least) requires Scaled<T> {
  return glm::length(x) < least ? T(real(0) * x) : x;
}
template <class T>
T below(const T& x, real most) requires Scaled<T> {
  return glm::length(x) > most ? T(x * (most / glm::length(x))) : x;
}

// One of two operands if it has the type of the whole; else the whole.
template <class Part, class Whole>
auto part_of(const Part& part, const Whole& whole) {
  if constexpr (std::is_same_v<Part, Whole>) return part;
  else return kept<Whole>(Whole(whole));
}
template <class A, class B>
auto first(const A& a, const B& b) { return part_of(a, a * b); }
template <class A, class B>
auto second(const A& a, const B& b) { return part_of(b, a * b); }
template <class A, class B>
auto undivided(const A& a, const B& b) { return part_of(a, a / b); }
template <class A, class B>
auto first_term(const A& a, const B& b) { return part_of(a, a + b); }
template <class A, class B>
auto second_term(const A& a, const B& b) { return part_of(b, a + b); }
template <class A, class B>
auto less_term(const A& a, const B& b) { return part_of(minus(b), a - b); }
template <class A, class B>
auto over(const A& a, const B& b) {
  if constexpr (std::is_floating_point_v<B> && Scaled<A>) return a / b;
  else return kept<decltype(a * b)>(a * b);
}
template <class A, class B>
auto exchanged(const A& a, const B& b) {
  if constexpr (requires { b * a; } && !std::is_arithmetic_v<A> && !std::is_arithmetic_v<B>) {
    return part_of(b * a, a * b);
  } else {
    return kept<decltype(a * b)>(a * b);
  }
}

}  // namespace joints::testing
