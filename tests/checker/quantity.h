// A number that carries kilograms, metres and seconds. The units tests compile an exercise file
// with it in place of `real`; it refuses a sum, a difference or a comparison of unlike units.
#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <concepts>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace joints {

/// The powers of kg, m and s; all zero for a pure number. Square roots leave halves.
using Unit = std::array<float, 3>;

/// The unit of a product a^p b^q.
constexpr Unit combined(const Unit& a, float p, const Unit& b, float q) {
  return {p * a[0] + q * b[0], p * a[1] + q * b[1], p * a[2] + q * b[2]};
}

/// Is it a unit that somebody may have meant? That of a value that was never set is not.
constexpr bool sensible(const Unit& unit) {
  for (const float power : unit)
    if (!(power >= -9 && power <= 9 && 2 * power == float(int(2 * power)))) return false;
  return true;
}

/// "kg m/s", "1/(kg m^2)", "a pure number".
inline std::string in_words(const Unit& unit) {
  std::string above, below;
  int factors_below = 0;
  for (int i = 0; i < 3; ++i) {
    if (unit[i] == 0) continue;
    const float power = std::abs(unit[i]);
    std::string factor = std::array{"kg", "m", "s"}[i];
    if (power != 1) factor += "^" + std::to_string(power).substr(0, power == int(power) ? 1 : 3);
    std::string& side = unit[i] > 0 ? above : below;
    side += (side.empty() ? "" : " ") + factor;
    factors_below += unit[i] < 0;
  }
  if (below.empty()) return above.empty() ? "a pure number" : above;
  return (above.empty() ? "1" : above) + "/" + (factors_below > 1 ? "(" + below + ")" : below);
}

/// Two units that do not go together.
struct UnitError : std::logic_error {
  Unit first, second;  ///< of the first operand, of the second
  UnitError(const std::string& words, const Unit& first, const Unit& second)
      : std::logic_error(words), first(first), second(second) {}
};

/// The number. A literal of the code is not `measured`: it has no unit, may be compared with
/// anything (a threshold), and where it is 0 or infinite it takes the unit of its neighbour.
/// No conversion to double: an answer that needs one does not compile and is not checked.
struct Quantity {
  double value;
  Unit unit;
  bool measured;

  Quantity() = default;  // trivial, as GLM's unions want it
  template <class Number>
    requires std::integral<Number> || std::floating_point<Number>
  constexpr Quantity(Number number) : Quantity(double(number), {}, false) {}
  constexpr Quantity(double value, const Unit& unit, bool measured)
      : value(value), unit(unit), measured(measured) {}
  template <std::integral Number>
  explicit constexpr operator Number() const { return Number(value); }

  /// Zero, infinite or NaN as written in the code.
  constexpr bool takes_any_unit() const { return !measured && !(value - value == 0 && value != 0); }

  friend constexpr Quantity operator+(Quantity a) { return a; }
  friend constexpr Quantity operator-(Quantity a) { return {-a.value, a.unit, a.measured}; }
  friend constexpr Quantity operator+(Quantity a, Quantity b) {
    return {a.value + b.value, common(a, b, "adding", "to"), a.measured || b.measured};
  }
  friend constexpr Quantity operator-(Quantity a, Quantity b) {
    return {a.value - b.value, common(a, b, "taking", "from"), a.measured || b.measured};
  }
  friend constexpr Quantity operator*(Quantity a, Quantity b) {
    return product(a.value * b.value, a, b, 1);
  }
  friend constexpr Quantity operator/(Quantity a, Quantity b) {
    return product(a.value / b.value, a, b, -1);
  }
  friend constexpr bool operator==(Quantity a, Quantity b) { return (a <=> b) == 0; }
  friend constexpr std::partial_ordering operator<=>(Quantity a, Quantity b) {
    if (a.measured && b.measured) common(a, b, "comparing", "with");
    return a.value <=> b.value;
  }
  constexpr Quantity& operator+=(Quantity b) { return *this = *this + b; }
  constexpr Quantity& operator-=(Quantity b) { return *this = *this - b; }
  constexpr Quantity& operator*=(Quantity b) { return *this = *this * b; }
  constexpr Quantity& operator/=(Quantity b) { return *this = *this / b; }

  /// The unit that both have. \throws UnitError such as "adding kg to 1/kg"
  static constexpr Unit common(Quantity a, Quantity b, const char* doing, const char* between) {
    if (a.takes_any_unit()) return b.unit;
    if (!b.takes_any_unit() && a.unit != b.unit)
      throw UnitError(std::string(doing) + " " + in_words(b.unit) + " " + between + " " +
                          in_words(a.unit), a.unit, b.unit);
    return a.unit;
  }

 private:
  static constexpr Quantity product(double value, Quantity a, Quantity b, float power) {
    if (a.takes_any_unit() || b.takes_any_unit()) return value;
    return {value, combined(a.unit, 1, b.unit, power), a.measured || b.measured};
  }
};

// ---- what is called for numbers --------------------------------------------------------------

/// f of a pure number. \throws UnitError such as "the sine of m"
inline Quantity of_pure(const char* name, double (*f)(double), Quantity a) {
  if (a.unit != Unit{})
    throw UnitError(std::string("the ") + name + " of " + in_words(a.unit), {}, a.unit);
  return {f(a.value), {}, a.measured};
}
inline Quantity sin(Quantity a) { return of_pure("sine", std::sin, a); }
inline Quantity cos(Quantity a) { return of_pure("cosine", std::cos, a); }
inline Quantity tan(Quantity a) { return of_pure("tangent", std::tan, a); }
inline Quantity asin(Quantity a) { return of_pure("arc sine", std::asin, a); }
inline Quantity acos(Quantity a) { return of_pure("arc cosine", std::acos, a); }
inline Quantity atan(Quantity a) { return of_pure("arc tangent", std::atan, a); }
inline Quantity exp(Quantity a) { return of_pure("exponential", std::exp, a); }
inline Quantity exp2(Quantity a) { return of_pure("exponential", std::exp2, a); }
inline Quantity expm1(Quantity a) { return of_pure("exponential", std::expm1, a); }
inline Quantity log(Quantity a) { return of_pure("logarithm", std::log, a); }
inline Quantity log1p(Quantity a) { return of_pure("logarithm", std::log1p, a); }
inline Quantity floor(Quantity a) { return of_pure("whole part", std::floor, a); }
inline Quantity ceil(Quantity a) { return of_pure("whole part", std::ceil, a); }
inline Quantity round(Quantity a) { return of_pure("whole part", std::round, a); }
inline Quantity abs(Quantity a) { return {std::abs(a.value), a.unit, a.measured}; }
inline Quantity fabs(Quantity a) { return abs(a); }
inline Quantity pow(Quantity a, double n) {
  return {std::pow(a.value, n), combined(a.unit, float(n), {}, 0), a.measured};
}
inline Quantity pow(Quantity a, Quantity n) {
  if (n.unit != Unit{})
    throw UnitError("raising to the power of " + in_words(n.unit), {}, n.unit);
  return {std::pow(a.value, n.value), combined(a.unit, float(n.value), {}, 0),
          a.measured || n.measured};
}
inline Quantity sqrt(Quantity a) { return pow(a, 0.5); }
inline Quantity atan2(Quantity y, Quantity x) {
  Quantity::common(y, x, "the angle of", "and");
  return {std::atan2(y.value, x.value), {}, y.measured || x.measured};
}
inline Quantity left_over(double (*f)(double, double), Quantity a, Quantity b) {
  const Unit unit = Quantity::common(a, b, "the remainder by", "of");
  return {f(a.value, b.value), unit, a.measured || b.measured};
}
inline Quantity remainder(Quantity a, Quantity b) { return left_over(std::remainder, a, b); }
inline Quantity fmod(Quantity a, Quantity b) { return left_over(std::fmod, a, b); }
inline bool isfinite(Quantity a) { return std::isfinite(a.value); }
inline bool isnan(Quantity a) { return std::isnan(a.value); }

}  // namespace joints

// The code says std::sqrt, so that the functions have to be there, too.
namespace std {
using joints::sin, joints::cos, joints::tan, joints::asin, joints::acos, joints::atan, joints::exp;
using joints::floor, joints::ceil, joints::round, joints::abs, joints::fabs, joints::pow;
using joints::sqrt, joints::atan2, joints::remainder, joints::fmod, joints::isfinite, joints::isnan;
using joints::exp2, joints::expm1, joints::log, joints::log1p;

template <>
struct numeric_limits<joints::Quantity> : numeric_limits<double> {};
template <>
inline constexpr joints::Quantity numbers::pi_v<joints::Quantity> = numbers::pi;
}  // namespace std
