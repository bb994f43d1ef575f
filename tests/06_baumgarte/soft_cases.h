// Exercise 6.4 as tables of cases: the two numbers of a soft row, and an iteration of a soft block.
#pragma once

#include <numbers>

#include "tests/06_baumgarte/warm_cases.h"
#include "tests/checker/arguments.h"

namespace joints::testing {

// ---- the two numbers ----------------------------------------------------------------------------

inline constexpr Subject soft_row_subject{"6.4", "the two numbers of a soft row"};
inline constexpr Subject soft_iteration_subject{"6.4", "an iteration of a soft block", 2};

struct SoftRowCase {
  std::string words;
  double frequency, damping, h;
};
inline SoftRowCase soft_row_case(double frequency, double damping, double rate) {
  return {"f " + short_number(frequency) + " zeta " + short_number(damping) + " h 1/" +
              short_number(rate), frequency, damping, 1 / rate};
}

/// The spring k and the damper c of 1 kg, both taken at the end of the step.
inline Numbers spring_at_the_end(double frequency, double damping, double h) {
  const double k = std::pow(2 * std::numbers::pi * frequency, 2), c = 2 * damping * std::sqrt(k);
  return {k / (c + h * k), 1 / (h * c + h * h * k)};
}

inline CaseTable<SoftRowCase> soft_row_table() {
  using Case = SoftRowCase;
  CaseTable<Case> table{soft_row_subject, {"rate", "softness"}, {}, {}, {}, {}};
  table.right = [](const Case& c) { return spring_at_the_end(c.frequency, c.damping, c.h); };
  judge(table, soft_row, [](auto row, const Case& c) {
    const SoftRow soft = row(real(c.frequency), real(c.damping), real(c.h));
    return Numbers{double(soft.rate), double(soft.softness)};
  });
  for (const double rate : {60.0, 240.0, 72.5})
    for (const double frequency : {10.0, 60.0, 1.5})
      for (const double damping : {2.0, 0.3, 1.0, 0.0})
        table.cases.push_back(soft_row_case(frequency, damping, rate));
  table.whole = true;
  table.tolerance = 100 * rounding;
  return table;
}

// ---- an iteration -------------------------------------------------------------------------------

struct SoftCase {
  std::string words;
  JointRows rows;
  SoftRow soft;
  vec3 lambda;
  Pair pair;
};

inline mat3 K_of(const Jacobian<3>& J, const Pair& pair) {
  const Matrix<3> dense = dense_K(J, pair.body1, pair.body2);
  mat3 K(0);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) K[j][i] = dense[i][j];
  return K;
}
inline SoftCase soft_case(const std::string& words, const SoftRow& soft, unsigned seed) {
  const WarmCase c = warm_case(words, 1, seed);
  Random random(seed + 10);
  return {words, {c.J, K_of(c.J, c.pair), random.vector(real(0.1))}, soft, c.lambda, c.pair};
}

/// The impulse that the block should have in all, less the one that it has.
inline vec3 right_soft_change(const SoftCase& c) {
  const auto& [J, K, C] = c.rows;
  vec3 wanted = K * c.lambda - c.soft.rate * C;
  for (int i = 0; i < 3; ++i) wanted[i] -= row_velocity(J[i], c.pair.body1, c.pair.body2);
  return inverse((1 + c.soft.softness) * K) * wanted - c.lambda;
}

inline CaseTable<SoftCase> soft_iteration_table() {
  using Case = SoftCase;
  CaseTable<Case> table{soft_iteration_subject,
                        {"lambda kept", "change of v1", "change of w1", "change of v2",
                         "change of w2"}, {}, {}, {}, {}};
  judge(table, soft_iteration, [](auto iterate, const Case& c) {
    vec3 lambda = c.lambda;
    Pair after = c.pair;
    iterate(c.rows, c.soft, lambda, after.body1, after.body2);
    return flat({lambda, after.body1.v - c.pair.body1.v, after.body1.w - c.pair.body1.w,
                 after.body2.v - c.pair.body2.v, after.body2.w - c.pair.body2.w});
  });
  table.right = [](const Case& c) {
    const vec3 change = right_soft_change(c);
    const Moves a = response<3>(c.rows.J, to_vector(change), c.pair);
    return flat({c.lambda + change, a.way1, a.turn1, a.way2, a.turn2});
  };
  table.cases = {soft_case("a soft one", {20, real(0.3)}, 641),
                 soft_case("a softer one", {5, 4}, 642),
                 soft_case("no bias", {0, real(0.5)}, 643),
                 soft_case("a hard one with a bias", {12, 0}, 644),
                 soft_case("hard, no bias", {0, 0}, 645),
                 soft_case("1 static", {20, real(0.3)}, 646)};
  Case& last = table.cases.back();
  last.pair.body1 = static_body(last.pair.body1.x, last.pair.body1.q);
  last.rows.K = K_of(last.rows.J, last.pair);
  table.tolerance = 1000 * rounding;
  return table;
}

}  // namespace joints::testing
