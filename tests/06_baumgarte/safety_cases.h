// Exercise 6.2, when a warm start is safe, as a table of scenes.
#pragma once

#include "chapters/06_baumgarte/baumgarte.h"
#include "tests/checker/cases.h"

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

/// By what the error is multiplied per step.
inline double growth(const SafetyCase& c) {
  return (1 + c.beta) * std::exp(c.iterations * std::log(c.rho));
}

inline CaseTable<SafetyCase> safety_table() {
  CaseTable<SafetyCase> table{{"6.2", "is a warm start safe? (1 yes, 0 no)", 2}, {"safe"},
                              {}, {}, {}, {}};
  judge(table, warm_start_is_safe, [](auto safe, const SafetyCase& c) {
    return Numbers{safe(real(c.rho), int(c.iterations), real(c.beta)) ? 1.0 : 0.0};
  });
  table.right = [](const SafetyCase& c) {
    const bool at_bound = std::abs(growth(c) - 1) < 1e-12;
    return Numbers{!at_bound && growth(c) < 1 ? 1.0 : 0.0};
  };
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
    if (std::abs(growth(c) - 1) > 0.02) table.cases.push_back(c);
  }
  table.whole = true;
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
