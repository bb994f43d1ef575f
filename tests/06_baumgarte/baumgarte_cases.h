// Exercise 6.1 as tables of cases, each with its usual mistakes: bias, limit, half-time.
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

/// The mistakes that one can make with b = beta C/h, as functions of C, beta and h.
using BiasRule = Call<double(double, double, double)>;
inline std::vector<Mistake<BiasRule>> wrong_biases() {
  return {
      {"h is forgotten: beta C is a length, b is a velocity",
       [](double C, double beta, double) { return beta * C; }},
      {"times h where it must be divided by h",
       [](double C, double beta, double h) { return beta * C * h; }},
      {"60 in the place of 1/h: a step may have another length than 1/60 s",
       [](double C, double beta, double) { return beta * C * 60; }},
      {"#over-60 divided by 60: one over h is times 60, and a step need not be 1/60 s",
       [](double C, double beta, double) { return beta * C / 60; }},
      {"#sign-b-has-sign the sign: b has the sign of C. J V + b = 0 turns it round already",
       [](double C, double beta, double h) { return -beta * C / h; }},
      {"beta is forgotten: this takes all of the error in one step",
       [](double C, double, double h) { return C / h; }},
      {"1 - beta is the fraction that stays: b removes the fraction beta",
       [](double C, double beta, double h) { return (1 - beta) * C / h; }},
      {"#fixed-beta 0.2 in the place of beta: take the one that is given",
       [](double C, double, double h) { return 0.2 * C / h; }},
      {"1 - beta is the fraction that stays: b removes the fraction beta. And the sign",
       [](double C, double beta, double h) { return (beta - 1) * C / h; }},
      {"divided by beta: beta is a fraction, a factor",
       [](double C, double beta, double h) { return C / (beta * h); }},
      {"divided by h twice: that is an acceleration",
       [](double C, double beta, double h) { return beta * C / (h * h); }},
      {"the size of C: an error has a sign, and so has its correction",
       [](double C, double beta, double h) { return beta * std::abs(C) / h; }},
      {"only positive errors are fed back",
       [](double C, double beta, double h) { return beta * std::max(C, 0.0) / h; }},
      {"only negative errors are fed back",
       [](double C, double beta, double h) { return beta * std::min(C, 0.0) / h; }},
      {"#of-small-errors an error of a few centimetres counts as none: there is no threshold here",
       [](double C, double beta, double h) { return std::abs(C) < 0.05 ? 0 : beta * C / h; }},
      {"C itself is returned", [](double C, double, double) { return C; }},
      {"it is always zero", [](double, double, double) { return 0.0; }}};
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

inline CaseTable<BiasCase> bias_table() {
  using Case = BiasCase;
  CaseTable<Case> table{{"6.1", "the bias of an equality"}, {"b"}, {}, {}, {}, bias_cases()};
  table.yours = [](const Case& c) {
    return Numbers{double(bias(real(c.C), real(c.beta), real(c.h)))};
  };
  table.right = [](const Case& c) { return Numbers{c.beta * c.C / c.h}; };
  for (const auto& [words, rule] : wrong_biases())
    table.mistakes.push_back({words, [rule = rule](const Case& c) {
                                return Numbers{rule(c.C, c.beta, c.h)};
                              }});
  find_bound(table);
  add_formulas(table, bias_arguments);
  table.tolerance = 10 * rounding;
  return table;
}

inline CaseTable<BiasCase> limit_bias_table() {
  using Case = BiasCase;
  const BiasRule behind = [](double C, double beta, double h) { return beta * C / h; };
  const BiasRule all = [](double C, double, double h) { return C / h; };
  const BiasRule none = [](double, double, double) { return 0.0; };
  // one rule where the limit is passed and one where it lies ahead
  const auto rules = [](const BiasRule& passed, const BiasRule& ahead) {
    return [=](const Case& c) {
      return Numbers{(c.C < 0 ? passed : ahead)(c.C, c.beta, c.h)};
    };
  };
  const auto scaled = [](const BiasRule& rule, double factor) {
    return BiasRule([=](double C, double beta, double h) { return factor * rule(C, beta, h); });
  };
  const char* const is_ahead = "a limit that lies ahead";

  CaseTable<Case> table{{"6.1", "the bias of a limit", 2}, {"b"}, {}, {}, {}, bias_cases()};
  table.yours = [](const Case& c) {
    return Numbers{double(limit_bias(real(c.C), real(c.beta), real(c.h)))};
  };
  table.right = rules(behind, all);
  table.mistakes = {
      {std::string(is_ahead) + " needs no beta: C/h just reaches it, beta C/h brakes long before",
       rules(behind, behind)},
      {std::string(is_ahead) + " stops the approach far from it: b = 0 gives up the gap C. It "
                               "may come as near as C/h", rules(behind, none)},
      {"a limit that is passed comes back by the fraction beta: C/h throws it back in one step",
       rules(all, all)},
      {"the two lines are exchanged: the fraction beta belongs to C < 0", rules(all, behind)},
      {"the sign: b has the sign of C on both sides", rules(scaled(behind, -1), scaled(all, -1))},
      {std::string("the sign of ") + is_ahead + ": b has the sign of C on both sides",
       rules(behind, scaled(all, -1))},
      {"the sign of a limit that is passed: b has the sign of C on both sides",
       rules(scaled(behind, -1), all)},
      {"nothing is done where the limit is passed: it has to come back", rules(none, all)},
      {"h is forgotten on both sides: b is a velocity",
       [](const Case& c) { return Numbers{c.C < 0 ? c.beta * c.C : c.C}; }},
      {std::string("h is forgotten for ") + is_ahead + ": b is a velocity",
       [](const Case& c) { return Numbers{c.C < 0 ? c.beta * c.C / c.h : c.C}; }},
      {"h is forgotten where the limit is passed: b is a velocity",
       [](const Case& c) { return Numbers{c.C < 0 ? c.beta * c.C : c.C / c.h}; }},
      {"the larger one of the two: that is the right one only where beta is below 1, the sign of C "
       "decides",
       [](const Case& c) { return Numbers{std::max(c.beta * c.C, c.C) / c.h}; }},
      {"the smaller one of the two: the sign of C decides",
       [](const Case& c) { return Numbers{std::min(c.beta * c.C, c.C) / c.h}; }},
      {"60 in the place of 1/h: a step may have another length than 1/60 s",
       [](const Case& c) { return Numbers{60 * (c.C < 0 ? c.beta * c.C : c.C)}; }},
      {"#compared-with-beta C is compared with beta: the sign of C decides",
       [](const Case& c) { return Numbers{(c.C < c.beta ? c.beta : 1) * c.C / c.h}; }},
      {"1 - beta for a limit that lies ahead: C/h just reaches it",
       [](const Case& c) { return Numbers{(c.C < 0 ? c.beta : 1 - c.beta) * c.C / c.h}; }}};
  for (const auto& [words, rule] : wrong_biases())
    if (!table.knows(rules(rule, rule))) table.mistakes.push_back({words, rules(rule, rule)});
  find_bound(table);
  add_formulas(table, bias_arguments);
  read_off(table, [yours = table.yours] {  // each of the two lines by itself
    std::string line[2];
    for (const bool ahead : {false, true}) {
      std::vector<Case> cases = bias_cases();
      std::erase_if(cases, [=](const Case& c) { return c.C == 0 || (c.C > 0) != ahead; });
      line[ahead] = formula_of<Case>(cases, [&](const Case& c) { return yours(c)[0]; },
                                     bias_arguments);
    }
    return line[0].empty() || line[1].empty() ? ""
           : "where C < 0 yours is " + line[0] + ", and where C > 0 it is " + line[1];
  });
  table.tolerance = 10 * rounding;
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
  // what is right of the number of half-times that a step lasts
  const auto of_ratio = [](auto beta) {
    return [=](const Case& c) { return Numbers{beta(c.h / c.half_time)}; };
  };
  const double ln2 = std::log(2.0);

  CaseTable<Case> table{{"6.1", "beta for a half-time", 3}, {"beta"}, {}, {}, {}, {}};
  table.yours = [](const Case& c) {
    return Numbers{double(beta_for(real(c.half_time), real(c.h)))};
  };
  table.right = of_ratio([](double t) { return 1 - std::exp2(-t); });
  table.mistakes = {
      {"#time-upside-down h and T are exchanged: a step lasts h/T half-times",
       of_ratio([](double t) { return 1 - std::exp2(-1 / t); })},
      {"e in the place of 2: after the time T 1/e remains, and not a half",
       of_ratio([](double t) { return 1 - std::exp(-t); })},
      {"e in the place of 2, and h and T are exchanged",
       of_ratio([](double t) { return 1 - std::exp(-1 / t); })},
      {"#time-straight-line a straight line, h/(2T): each step removes a fraction of the REMAINING "
       "error, so the factors multiply",
       of_ratio([](double t) { return t / 2; })},
      {"a straight line, h/T: each step removes a fraction of the REMAINING error, so the factors "
       "multiply",
       of_ratio([](double t) { return t; })},
      {"a straight line, h ln(2)/T: that is right only where h is much shorter than T",
       of_ratio([=](double t) { return ln2 * t; })},
      {"#time-share-that-left this is the fraction that remains after a step, beta is the removed "
       "one: 1 minus it",
       of_ratio([](double t) { return std::exp2(-t); })},
      {"this is the fraction that remains after a step, and e in the place of 2",
       of_ratio([](double t) { return std::exp(-t); })},
      {"the sign of the exponent: 2 to the power -h/T",
       of_ratio([](double t) { return 1 - std::exp2(t); })},
      {"the sign of the exponent, and of the whole: 1 - 2 to the power -h/T",
       of_ratio([](double t) { return std::exp2(t) - 1; })},
      {"h is forgotten in the exponent: 2 to the power -h/T",
       [](const Case& c) { return Numbers{1 - std::exp2(-1 / c.half_time)}; }},
      {"h times T in the exponent: it is divided by T",
       [](const Case& c) { return Numbers{1 - std::exp2(-c.h * c.half_time)}; }},
      {"T is forgotten in the exponent: 2 to the power -h/T",
       [](const Case& c) { return Numbers{1 - std::exp2(-c.h)}; }},
      {"1/60 in the place of h: a step need not be 1/60 s",
       [](const Case& c) { return Numbers{1 - std::exp2(-1 / (60 * c.half_time))}; }},
      {"h/T is cut to a whole number: it is a real, a step is a part of a half-time",
       of_ratio([](double t) { return 1 - std::exp2(-std::floor(t)); })},
      {"#time-whole-numbers it is always 1: 1/2 of whole numbers is 0, write real(0.5) or "
       "std::exp2",
       of_ratio([](double) { return 1.0; })},
      {"this is a half in every step: h/T is forgotten", of_ratio([](double) { return 0.5; })},
      {"#time-whole-steps T/h is cut to a whole number: it is a real, a half-time need not be "
       "whole steps",
       of_ratio([](double t) { return 1 - std::exp2(-1 / std::floor(1 / t)); })},
      {"it is always 0: h, or the answer, is cut to a whole number: an int has no fraction",
       of_ratio([](double) { return 0.0; })},
      {"h/T is rounded to whole half-times: it is a real",
       of_ratio([](double t) { return 1 - std::exp2(-std::round(t)); })},
      {"the sign of the whole: 1 minus 2 to the power -h/T",
       of_ratio([](double t) { return std::exp2(-t) - 1; })},
      {"half of the remaining fraction: 1 minus 2 to the power -h/T",
       of_ratio([](double t) { return std::exp2(-t) / 2; })}};
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
