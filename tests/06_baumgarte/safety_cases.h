// Exercise 6.2, when a warm start is safe, as a table of scenes with its usual mistakes.
#pragma once

#include "chapters/06_baumgarte/baumgarte.h"
#include "tests/checker/arguments.h"
#include "tests/checker/pieces.h"

namespace joints::testing {

struct SafetyCase {
  std::string words;
  double rho, iterations, beta;
};
inline SafetyCase safety_case(double rho, int iterations, double beta) {
  return {"rho " + short_number(rho) + " iterations " + std::to_string(iterations) + " beta " +
              short_number(beta), rho, double(iterations), beta};
}

inline const double ten_links = std::pow(std::cos(std::acos(-1.0) / 20), 2);  // rho of a chain

/// The two compared quantities.
struct SafetyReference {
  SafetyCase c;
  double left, more, bound = 1;  ///< left * more < bound
  bool at_bound = false, negated = false;
  explicit SafetyReference(const SafetyCase& c)
      : c(c), left(std::pow(c.rho, c.iterations)), more(1 + c.beta) {}
  bool safe() const {
    const double a = left * more;
    return (at_bound ? a <= bound : a < bound) != negated;
  }
};

inline Pieces<SafetyReference> wrong_safeties() {
  using T = SafetyReference;
  const auto power = [](auto exponent) {
    return Call<void(T&)>(
        [=](T& t) { t.left = std::pow(t.c.rho, exponent(t.c.iterations)); });
  };
  const auto left = [](auto of) {
    return Call<void(T&)>([=](T& t) { t.left = of(t.c.rho, t.c.iterations); });
  };
  const auto more = [](auto of) {
    return Call<void(T&)>([=](T& t) { t.more = of(t.c.beta); });
  };
  const auto all = [](auto of) {  // another left side altogether
    return Call<void(T&)>([=](T& t) {
      t.left = of(t.left, t.c);
      t.more = 1;
    });
  };
  return {
      {"#rho-times-iterations rho times k: each iteration multiplies the error by rho, that is rho "
       "to the power k",
       left([](double rho, double k) { return rho * k; })},
      {"rho over k: each iteration multiplies the error by rho, that is rho to the power k",
       left([](double rho, double k) { return rho / k; })},
      {"the iterations are forgotten: k of them multiply by rho to the power k. Or 1 + beta has "
       "the power k, too: only rho has it",
       power([](double) { return 1; })},
      {"the square root: rho is the factor of a whole iteration",
       power([](double k) { return k / 2; })},
      {"twice the iterations: rho is the factor of a whole iteration",
       power([](double k) { return 2 * k; })},
      {"#one-iteration-less one iteration less: k iterations multiply by rho to the power k, the "
       "first one counts, too",
       power([](double k) { return k - 1; })},
      {"one iteration more: k iterations multiply by rho to the power k",
       power([](double k) { return k + 1; })},
      {"#by-the-rest 1 - rho to the power k: rho itself is the factor of an iteration",
       left([](double rho, double k) { return std::pow(1 - rho, k); })},
      {"e to the power -rho k: an iteration multiplies by rho, so k multiply by rho to the power k",
       left([](double rho, double k) { return std::exp(-rho * k); })},
      {"divided by 1 - beta: rho^k is multiplied by 1 + beta",
       [](T& t) { t.more = 1 / (1 - t.c.beta); }},
      {"1 is forgotten: 1 + beta and not beta", more([](double beta) { return beta; })},
      {"#other-side the sign of beta, or 1 + beta stands on the other side: rho^k times (1 + beta) "
       "is compared with 1. (1 - beta is the factor of an error in a cold step)",
       more([](double beta) { return 1 - beta; })},
      {"twice beta: it comes once a step", more([](double beta) { return 1 + 2 * beta; })},
      {"#by-a-sum rho^k + beta < 1, that is rho^k < 1 - beta: rho^k is multiplied by 1 + beta",
       all([](double left, const SafetyCase& c) { return left + c.beta; })},
      {"rho^k + rho beta < 1: rho^k is multiplied by 1 + beta",
       all([](double left, const SafetyCase& c) { return left + c.rho * c.beta; })},
      {"#rho-int beta is forgotten, or rho is cut to 0 by an int: feedback adds to the factor",
       more([](double) { return 1; })},
      {"beta is cut to a whole number: an int has no fraction",
       more([](double beta) { return 1 + std::trunc(beta); })},
      {"compared with beta: Eq. 6-9 compares rho^k (1 + beta) with 1",
       [](T& t) { t.more = 1, t.bound = t.c.beta; }},
      {"a factor of 2: rho^k (1 + beta) is compared with 1", [](T& t) { t.left *= 2; }},
      {"#with-a-reserve a bound below 1: rho^k (1 + beta) is compared with 1 itself",
       [](T& t) { t.bound = 0.9; }},
      {"at the bound the error does not decay: < and not <=", [](T& t) { t.at_bound = true; }},
      {"the other way round: true means safe", [](T& t) { t.negated = true; }},
      {"it is always safe: is anything compared, or is a variable never set?",
       [](T& t) { t.bound = 1e300; }},
      {"it is never safe. Are base and exponent exchanged? rho to the power k",
       [](T& t) { t.bound = -1; }}};
}

inline CaseTable<SafetyCase> safety_table() {
  CaseTable<SafetyCase> table{{"6.2", "is a warm start safe? (1 yes, 0 no)", 2}, {"safe"},
                              {}, {}, {}, {}};
  table.yours = [](const SafetyCase& c) {
    return Numbers{warm_start_is_safe(real(c.rho), int(c.iterations), real(c.beta)) ? 1.0 : 0.0};
  };
  table.right = [](const SafetyCase& c) { return Numbers{SafetyReference(c).safe() ? 1.0 : 0.0}; };
  const std::tuple<double, int, double> scenes[] = {
      {ten_links, 4, 0.15}, {ten_links, 6, 0.15}, {ten_links, 10, 0.15}, {ten_links, 10, 0.5},
      {ten_links, 30, 0.8}, {0.9, 1, 0.05},       {0.9, 1, 0.15},        {0.9, 2, 0.3},
      {0.9, 8, 0.9},        {0.99, 30, 0.2},      {0.99, 10, 0.2},       {0.7, 1, 1},
      {0.7, 2, 1},          {0.2, 1, 1.5},        {0.6, 1, 0.5},         {0.5, 1, 1},
      {1, 10, 0},           {1, 10, 0.2},         {0.999, 10, 0},        {0, 1, 1.9},
      {0.99, 10, 0.5},      {0.9, 1, 1.5},        {ten_links, 5, 0.15}};
  for (const auto& [rho, iterations, beta] : scenes)
    table.cases.push_back(safety_case(rho, iterations, beta));
  Random random(625);  // more of them, so that no mistake fits by chance; none near the bound
  while (table.cases.size() < 60) {
    const auto two_digits = [&](real least, real most) {
      return std::round(100 * double(random.uniform(least, most))) / 100;
    };
    const SafetyCase c = safety_case(two_digits(real(0.3), real(0.99)),
                                     1 + int(random.uniform(0, 8)), two_digits(0, real(1.9)));
    const SafetyReference reference(c);
    if (std::abs(reference.left * reference.more - 1) > 0.02) table.cases.push_back(c);
  }
  table.whole = true;
  add_pieces(
      table, [](const SafetyCase& c) { return SafetyReference(c); },
      [](const SafetyReference& t) { return Numbers{t.safe() ? 1.0 : 0.0}; }, wrong_safeties());
  return table;
}

// One row whose iterations each multiply the error by rho, with a weight on it, warm:
// how far is it from its place in the end?
inline double runs_away(const SafetyCase& scene) {
  const double h = 1.0 / 60;
  double C = 1e-3, v = 0, kept = 0;  // for 1 kg
  for (int step = 0; step < 2000; ++step) {
    v += -9.81 * h + kept;
    for (int iteration = 0; iteration < scene.iterations; ++iteration) {
      const double lambda = -(1 - scene.rho) * (v + scene.beta * C / h);
      v += lambda;
      kept += lambda;
    }
    C += h * v;
  }
  return std::abs(C);
}

}  // namespace joints::testing
