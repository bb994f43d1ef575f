// Exercise 8.2: what a solve adds to the impulse of friction as a table of cases.
#pragma once

#include <algorithm>

#include "chapters/08_ground/ground.h"
#include "tests/checker/arguments.h"

namespace joints::testing {

struct FrictionCase {
  std::string words;
  double rate, K, mu, normal, sum, speed = std::abs(rate);
};
inline const Arguments<FrictionCase> friction_arguments{{"rate", &FrictionCase::rate, "m/s"},
                                                        {"K", &FrictionCase::K, "1/kg"},
                                                        {"mu", &FrictionCase::mu},
                                                        {"normal", &FrictionCase::normal, "N s"},
                                                        {"sum", &FrictionCase::sum, "N s"}};
inline std::string friction_given(const FrictionCase& c) {
  return "Case: " + arguments_of(c, friction_arguments) + ".";
}

/// The formula of the bound, or of the required impulse, where it is not the right one; "" where
/// neither is seen in the sums.
inline std::string other_formula(const CaseTable<FrictionCase>& table) {
  using Case = FrictionCase;
  const auto new_sum = [yours = table.yours](const Case& c) { return yours(c)[1]; };
  const auto wanted = [](const Case& c) { return c.sum - c.rate / c.K; };
  std::vector<Case> bounded, within;
  for (const Case& c : table.cases) {
    if (!near(table.yours(c)[0], new_sum(c) - c.sum, table.tolerance)) return "";
    if (!near(new_sum(c), wanted(c), table.tolerance)) bounded.push_back(c);
    if (std::abs(new_sum(c)) < c.mu * c.normal - table.tolerance) within.push_back(c);
  }
  const auto formula = [](const std::vector<Case>& cases, const Call<double(const Case&)>& of,
                          const Arguments<Case>& arguments) {
    return cases.size() < 6 ? "" : formula_of<Case>(cases, of, arguments);
  };
  const Arguments<Case>& all = friction_arguments;
  const std::string bound =
      formula(bounded, [=](const Case& c) { return std::abs(new_sum(c)); },
              {all[2], all[3], all[1], {"|rate|", &Case::speed}});
  if (!bound.empty() && bound != "mu normal") return "the bound is mu normal, yours is " + bound;
  for (const double sign : {1, 0, -1}) {
    const std::string rest = formula(
        within, [=](const Case& c) { return new_sum(c) - sign * c.sum; }, {all[0], all[1]});
    if (rest.empty() || rest == "0" || (sign == 1 && rest == "-rate / K")) continue;
    const bool minus = rest[0] == '-';
    return std::string("sum - rate / K is wanted, yours is ") +
           (sign > 0 ? "sum " : sign < 0 ? "-sum " : "") + (minus ? "- " : "+ ") +
           rest.substr(minus);
  }
  return "";
}

inline CaseTable<FrictionCase> friction_table() {
  CaseTable<FrictionCase> table{{"8.2", "the impulse of friction", 2}, {"change", "sum"}, {}, {},
                                {}, {}};
  table.given = friction_given;
  judge(table, friction_impulse, [](auto friction, const FrictionCase& c) {
    real sum = real(c.sum);
    const double change =
        double(friction(real(c.rate), real(c.K), real(c.mu), real(c.normal), sum));
    return Numbers{change, double(sum)};
  });
  table.right = [](const FrictionCase& c) {
    const double bound = c.mu * c.normal, sum = std::clamp(c.sum - c.rate / c.K, -bound, bound);
    return Numbers{sum - c.sum, sum};
  };
  for (const double way : {1, -1}) {
    const auto add = [&](double rate, double K, double mu, double normal, double sum) {
      table.cases.push_back({"", way * rate, K, mu, normal, way * sum});
    };
    add(2.88, 11.0 / 60, 0.5, 1.2, 0);      // the text's: slides on
    add(2.77, 11.0 / 60, 0.5, 1.2, -0.6);   // and once more
    add(0.05, 0.4, 0.5, 1.2, 0);            // within the bound: stops
    add(0.05, 0.4, 0.5, 1.2, -0.2);
    add(-0.1, 0.4, 0.5, 1.2, -0.4);         // gives back
    add(-3, 0.4, 0.5, 1.2, -0.4);           // gives all back, and brakes the other way
    add(0, 0.4, 0.5, 0.7, 0.6);             // the normal impulse has become less
    add(0.05, 0.4, 0.5, 0.7, 0.6);
    add(-1, 0.4, 0.5, 0.7, 0.6);
    add(0, 0.4, 0.5, 0, 0.6);               // lifted off
    add(-0.3, 0.4, 0.5, 0, 0.6);
    add(2, 2.5, 1.5, 3, 1.5);               // a rough ground, a light body
    add(-9, 1.25, 1.4, 1.6, 0.3);
    add(0.8, 0.125, 0.3, 2.4, -0.1);        // a smooth one, a heavy body
    add(-1.5, 0.8, 0.8, 0.9, 0.35);
    add(2, 2.5, 0, 3, 0);                   // no friction
  }
  table.tolerance = 10 * rounding;
  read_off(table, [=] { return other_formula(table); });
  return table;
}

}  // namespace joints::testing
