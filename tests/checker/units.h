// Asks an exercise for the units of its result, and says in a sentence what is wrong with them.
#pragma once

#include <span>

#include "engine/matrix.h"
#include "tests/checker/catch.h"
#include "tests/checker/thrown.h"
#include "tests/checker/unit_rates.h"

namespace joints::testing {

inline constexpr Quantity kg{1, {1, 0, 0}, true}, m{1, {0, 1, 0}, true}, s{1, {0, 0, 1}, true},
    pure{1, {}, true};  ///< radians are pure numbers, too
inline constexpr Quantity newton = kg * m / (s * s), h = real(0.1) * s;

/// A body with nothing special about it, but for its units.
inline Body moving_body(real mass, const vec3& moments, const vec3& x, const vec3& turn) {
  Body body = body_with(mass * kg, moments * (kg * m * m), x * m, rotation(turn));
  body.v = vec3(1, real(0.5), -2) * mass * (m / s);
  body.w = vec3(real(0.7), 3, -1) * mass / s;
  return body;
}
inline const Body body1 = moving_body(2, {real(0.5), real(0.4), real(0.6)}, {1, real(-0.5), 2},
                                      {real(0.3), real(-0.8), real(0.4)});
inline const Body body2 = moving_body(3, {real(0.3), real(0.7), real(0.9)}, {-2, real(1.5), 1},
                                      {real(0.9), real(0.2), real(0.5)});
inline const vec3 lever1 = vec3(real(0.4), real(-0.3), 1) * m;
inline const vec3 lever2 = vec3(-1, real(0.6), real(0.2)) * m;
inline const vec3 direction1(real(0.6), real(0.8), 0), direction2(real(-0.8), real(0.6), 0);

/// A row that feels both velocities and both turns.
inline const Row row = row_by_rates(direction1, lever1, lever2);

/// What often explains that `missing` is missing from a unit, or that its inverse is too many.
struct Reason {
  Quantity missing;
  const char* words;
  const char* too_many;
};
inline constexpr std::array reasons{
    Reason{m, "a lever is missing, or another length",
           "a length too many: a lever, or a direction that is not a unit vector"},
    Reason{m * m, "the levers are missing, r x n on both sides", "a squared length too many"},
    Reason{s, "h is missing (an impulse is h times a force, a bias is C/h)",
           "a time too many: is a division by h missing?"},
    Reason{1 / kg, "the inverse mass is missing", "an inverse mass too many"},
    Reason{1 / (kg * m * m), "the inverse inertia is missing", "an inverse inertia too many"},
    Reason{1 / (kg * kg), "a mass where an inverse mass belongs",
           "an inverse mass where a mass belongs (K is one, divide by it)"},
    Reason{1 / (kg * kg * m * m * m * m), "inertia where its inverse belongs",
           "an inverse inertia where inertia belongs (K may be one, divide by it)"}};

/// What an exercise knows better than the list above of a time that is missing or too many.
struct OfTime {
  const char* missing = nullptr;
  const char* too_many = nullptr;
};

/// ": a lever is missing", or nothing. \param sum of `wants` and `has`: either of them may be the
/// wrong one, and a length or a mass is missing more often than it is too many
inline std::string reason(const Unit& has, const Unit& wants, bool sum, const OfTime& time) {
  const Unit missing = combined(wants, 1, has, -1), too_many = combined(has, 1, wants, -1);
  if (missing == s.unit && time.missing) return std::string(": ") + time.missing;
  if (too_many == s.unit && time.too_many) return std::string(": ") + time.too_many;
  for (const Reason& one : reasons) {
    const bool turned = sum && one.missing.unit != s.unit && too_many == one.missing.unit;
    const bool either = sum && one.missing.unit != s.unit;
    if (missing == one.missing.unit || turned)
      return std::string(": ") + one.words + (either ? ", or is one too many beside it?" : "");
    if (too_many == one.missing.unit) return std::string(": ") + one.too_many;
  }
  return "";
}

/// A value that was never set, or is made of one: units have nothing to say to it.
inline bool unset(const Quantity& number) {
  return !sensible(number.unit) || std::abs(number.value) > 1e290;
}

/// Fails with a sentence unless every number of `yours` has the unit of `wanted`, or none.
template <class Numbers>  // a real, a vector, a matrix: some reals in a row at any rate
void expect_unit(const std::string& entry, const Numbers& yours, Quantity wanted,
                 const OfTime& time = {}) {
  const std::span numbers(reinterpret_cast<const real*>(&yours), sizeof yours / sizeof(real));
  for (const real& number : numbers) {
    if (number.takes_any_unit() || number.unit == wanted.unit || unset(number)) continue;
    const auto is = [](const Unit& unit) { return (unit == Unit{} ? "" : "in ") + in_words(unit); };
    FAIL("Units: " << entry << " is " << is(number.unit) << " and should be " << is(wanted.unit)
                   << reason(number.unit, wanted.unit, false, time));
  }
  SUCCEED();
}

/// Runs what calls an exercise; a sum of unlike units in it becomes a sentence. An exercise that
/// is not written says so itself.
template <class Call>
auto in(const std::string& entry, Call call, const OfTime& time = {}) {
  const auto explain = [&](const UnitError& error) {
    if (!sensible(error.first) || !sensible(error.second)) throw error;  // no sentence
    const std::string words = error.what();
    FAIL("Units: in " << entry << ", " << words
                      << (words.find("whole part") == words.npos
                              ? reason(error.second, error.first, true, time) : ""));
  };
  using Result = decltype(call());
  if constexpr (std::is_void_v<Result>) {
    if (const auto error = thrown_by<UnitError>(call)) explain(*error);
  } else {
    std::optional<Result> result;
    if (const auto error = thrown_by<UnitError>([&] { result.emplace(call()); })) explain(*error);
    return *result;
  }
}

/// The unit of the result of a call.
template <class Call>
void has_unit(const std::string& entry, Quantity wanted, Call call, const OfTime& time = {}) {
  expect_unit(entry, in(entry, call, time), wanted, time);
}

/// The units of a row, or of several: factors of velocities, factors of angular velocities.
template <class Call>
void row_has_units(const std::string& entry, Quantity v, Quantity w, Call call) {
  const auto has = [](const vec3& block, const Quantity& wanted) {
    for (int k = 0; k < 3; ++k)
      if (!block[k].takes_any_unit() && block[k].unit != wanted.unit) return false;
    return true;
  };
  for (const Row& row : to_jacobian(in(entry, call)).row) {
    if (has(row.v1, v) && has(row.w1, v) && !has(row.w1, w) && has(row.v2, w) && !has(row.v2, v))
      FAIL("Units: the blocks of " << entry << " are in another order: a row is {v1, w1, v2, w2}");
    expect_unit(entry + ".v1", row.v1, v);
    expect_unit(entry + ".v2", row.v2, v);
    expect_unit(entry + ".w1", row.w1, w);
    expect_unit(entry + ".w2", row.w2, w);
  }
}

/// The units of rows that only turn: no pushes at all.
template <class Call>
void row_of_turns_has_units(const std::string& entry, Quantity w, Call call) {
  for (const Row& row : to_jacobian(in(entry, call)).row) {
    if ((row.v1 != vec3(0) || row.v2 != vec3(0)) && !unset(row.v1.x) && !unset(row.v2.x))
      FAIL("Units: the blocks v1 and v2 of " << entry << " are zero: these rows only turn");
    expect_unit(entry + ".w1", row.w1, w);
    expect_unit(entry + ".w2", row.w2, w);
  }
}

/// The units of two velocities that a call changes.
template <class Call>
void keeps_velocities(const std::string& entry, Call call) {
  Body a = body1, b = body2;
  in(entry, [&] { call(a, b); });
  for (const Body* body : {&a, &b}) {
    expect_unit("the velocity v", body->v, m / s);
    expect_unit("the angular velocity w", body->w, 1 / s);
  }
}

}  // namespace joints::testing
