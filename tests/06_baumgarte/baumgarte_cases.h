// Exercise 6.1 as tables of cases: bias, limit, half-time.
#pragma once

#include <algorithm>

#include "chapters/06_baumgarte/baumgarte.h"
#include "tests/checker/arguments.h"

namespace joints::testing {

// ---- 6.1 the bias -------------------------------------------------------------------------------

struct BiasCase {
  std::string words;
  double C, beta, h;
};

/// An error, a fraction of it, and the number of steps per second.
inline BiasCase bias_case(double C, double beta, double rate) {
  return {"C " + short_number(C) + " beta " + short_number(beta) + " h 1/" + short_number(rate), C,
          beta, 1 / rate};
}
inline std::vector<BiasCase> bias_cases() {
  std::vector<BiasCase> out;
  for (const double rate : {60.0, 100.0, 10.0, 72.5})
    for (const double beta : {0.15, 0.8, 1.5})
      for (const double C : {-0.02, 0.02, -0.7, 0.3, 0.0, 1.3, -2.4})
        out.push_back(bias_case(C, beta, rate));
  return out;
}

inline const Arguments<BiasCase> bias_arguments{
    {"C", &BiasCase::C}, {"beta", &BiasCase::beta}, {"h", &BiasCase::h}};

/// Is b what is right, but kept from -most to most, whatever that is?
inline void find_bound(CaseTable<BiasCase>& table) {
  read_off(table, [yours = table.yours, right = table.right, cases = table.cases] {
    double most = 0;
    for (const BiasCase& c : cases) most = std::max(most, std::abs(yours(c)[0]));
    const bool kept = std::all_of(cases.begin(), cases.end(), [&](const BiasCase& c) {
      return std::abs(std::clamp(right(c)[0], -most, most) - yours(c)[0]) < 1e-9;
    });
    return kept ? "b is kept from -" + short_number(most) + " to " + short_number(most) +
                      ": there is no such bound" : "";
  });
}

/// A table of one of the two biases. \param right whatever C, beta and h are
inline CaseTable<BiasCase> bias_table(const Subject& subject, real (*yours)(real, real, real),
                                      double (*right)(const BiasCase&)) {
  CaseTable<BiasCase> table{subject, {"b"}, {}, {}, {}, bias_cases()};
  table.right = [=](const BiasCase& c) { return Numbers{right(c)}; };
  judge(table, yours, [](auto b, const BiasCase& c) {
    return Numbers{double(b(real(c.C), real(c.beta), real(c.h)))};
  });
  table.tolerance = 10 * rounding;
  find_bound(table);
  add_formulas(table, bias_arguments);
  return table;
}

inline CaseTable<BiasCase> bias_table() {
  return bias_table({"6.1", "the bias of an equality"}, bias,
                    [](const BiasCase& c) { return c.beta * c.C / c.h; });
}

inline CaseTable<BiasCase> limit_bias_table() {
  CaseTable<BiasCase> table =
      bias_table({"6.1", "the bias of a limit", 2}, limit_bias,
                 [](const BiasCase& c) { return (c.C < 0 ? c.beta : 1) * c.C / c.h; });
  read_off(table, [yours = table.yours] {  // each of the two lines by itself
    std::string line[2];
    for (const bool ahead : {false, true}) {
      std::vector<BiasCase> cases = bias_cases();
      std::erase_if(cases, [=](const BiasCase& c) { return c.C == 0 || (c.C > 0) != ahead; });
      line[ahead] = formula_of<BiasCase>(cases, [&](const BiasCase& c) { return yours(c)[0]; },
                                         bias_arguments);
    }
    return line[0].empty() || line[1].empty() ? ""
           : "where C < 0 yours is " + line[0] + ", and where C > 0 it is " + line[1];
  });
  return table;
}

// ---- 6.1 the half-time --------------------------------------------------------------------------

struct HalfTimeCase {
  std::string words;
  double half_time, h;
};
inline HalfTimeCase half_time_case(double half_time, double rate) {
  return {"T " + short_number(half_time) + " s, h 1/" + short_number(rate) + " s", half_time,
          1 / rate};
}

inline CaseTable<HalfTimeCase> half_time_table() {
  using Case = HalfTimeCase;
  CaseTable<Case> table{{"6.1", "beta for a half-time", 3}, {"beta"}, {}, {}, {}, {}};
  table.right = [](const Case& c) {
    return Numbers{-std::expm1(-std::log(2.0) * c.h / c.half_time)};
  };
  judge(table, beta_for, [](auto beta, const Case& c) {
    return Numbers{double(beta(real(c.half_time), real(c.h)))};
  });
  for (const double half_time : {0.1, 0.5, 0.02, 2.0})
    for (const double rate : {60.0, 120.0, 10.0, 72.5})
      table.cases.push_back(half_time_case(half_time, rate));
  const Arguments<Case> arguments{{"T", &Case::half_time}, {"h", &Case::h}};
  add_formulas(table, arguments);
  read_off(table, [=, yours = table.yours, cases = table.cases]() -> std::string {
    const auto formula = [&](auto of) {
      return formula_of<Case>(cases, [&](const Case& c) { return of(yours(c)[0]); }, arguments);
    };
    if (const auto left = formula([](double b) { return -std::log2(1 - b); }); !left.empty())
      return left == "h / T" ? "" : "yours is 1 - 2^-(" + left + ")";
    if (const auto left = formula([](double b) { return -std::log2(b); }); !left.empty())
      return "yours is 2^-(" + left + ")";
    if (const auto left = formula([](double b) { return 1 - b; }); !left.empty())
      return "yours is 1 - " + left;
    return "";
  });
  return table;
}

}  // namespace joints::testing
