// The count of turns of exercise 3.3 as a table of cases with its usual mistakes.
#pragma once

#include <algorithm>
#include <numbers>

#include "chapters/03_hinge/hinge.h"
#include "tests/checker/cases.h"

namespace joints::testing {

inline const char* const told_truncation_expected_turn =
    "#truncation-expected-turn the turns of `expected` alone: k comes from expected - measured";

struct TurnsCase {
  std::string words;
  double measured, expected;
};

inline CaseTable<TurnsCase> turns_table() {
  using Case = TurnsCase;
  constexpr double turn = 2 * std::numbers::pi;
  // measured plus `unit` times a whole number that comes from how many units are missing
  const auto plus = [](double unit, auto whole) {
    return [=](const Case& c) {
      return Numbers{c.measured + unit * whole((c.expected - c.measured) / unit)};
    };
  };
  const auto nearest = [](double k) { return std::round(k); };
  const char* const one_turn =
      "#one-turn one turn at most is added: a fast wheel makes several of them in a step";

  CaseTable<Case> table{{"3.3", "counting turns", 2}, {"unwrapped"}, {}, {}, {}, {}};
  table.yours = [](const Case& c) {
    return Numbers{double(unwrapped(real(c.measured), real(c.expected)))};
  };
  table.right = plus(turn, nearest);
  table.mistakes = {
      {"#measured `measured` is returned as it is: no turn is counted",
       [](const Case& c) { return Numbers{c.measured}; }},
      {"`expected` is returned: it decides only the turn; the angle is the measured one",
       [](const Case& c) { return Numbers{c.expected}; }},
      {one_turn, plus(turn, [](double k) { return std::clamp(std::round(k), -1.0, 1.0); })},
      {"#while-one-side only turns forward are added",
       plus(turn, [](double k) { return k > 0 ? std::round(k) : 0; })},
      {"only turns back are added",
       plus(turn, [](double k) { return k < 0 ? std::round(k) : 0; })},
      {"#int-truncation the number of turns is cut off (as std::fmod does), not rounded: the "
       "nearest one counts",
       plus(turn, [](double k) { return std::trunc(k); })},
      {"the number of turns is rounded down: the nearest one counts",
       plus(turn, [](double k) { return std::floor(k); })},
      {"the number of turns is rounded up: the nearest one counts",
       plus(turn, [](double k) { return std::ceil(k); })},
      {"turns in the wrong direction: measured + 2 pi k",
       plus(turn, [](double k) { return -std::round(k); })},
      {"half turns: a whole turn is 2 pi", plus(turn / 2, nearest)},
      {"degrees where radians belong: a whole turn is 2 pi", plus(360, nearest)},
      {"two turns at a time: a whole turn is 2 pi", plus(2 * turn, nearest)},
      {"#plus the sign of `expected`: the remainder is that of measured - "
       "expected", [](const Case& c) {
         return Numbers{c.expected + std::remainder(c.measured + c.expected, turn)};
       }},
      {"#if the angle nearest to `expected` counts, not one from 0 to 2 pi",
       [](const Case& c) { return Numbers{c.measured < 0 ? c.measured + turn : c.measured}; }},
      {"#threshold-only-when-far half a turn off is another turn already: the nearest one counts",
       [=](const Case& c) {
         const bool far = std::abs(c.measured - c.expected) >= turn;
         return far ? plus(turn, nearest)(c) : Numbers{c.measured};
       }},
      {told_truncation_expected_turn,
       [](const Case& c) { return Numbers{c.measured + turn * std::trunc(c.expected / turn)}; }},
      {"#while-adds-pi half turns are added: a whole turn is 2 pi", [](const Case& c) {
         double angle = c.measured;
         while (angle < c.expected - turn / 2) angle += turn / 2;
         while (angle > c.expected + turn / 2) angle -= turn / 2;
         return Numbers{angle};
       }},
      {"#round-no-turn the number of turns is added: each of them is 2 pi",
       [=](const Case& c) {
         return Numbers{c.measured + std::round((c.expected - c.measured) / turn)};
       }},
      {told_truncation_expected_turn,
       [=](const Case& c) { return Numbers{c.measured + turn * std::round(c.expected / turn)}; }},
      {"#bracket-forgotten a bracket is missing: the difference expected - measured is divided by "
       "2 pi",
       [=](const Case& c) {
         return Numbers{c.measured + turn * std::round(c.expected - c.measured / turn)};
       }},
      {"times 2 pi where it must be divided by 2 pi: how many turns is the difference?",
       [=](const Case& c) {
         return Numbers{c.measured + turn * std::round((c.expected - c.measured) * turn)};
       }},
      {"#swapped-remainder-args the arguments of std::remainder are exchanged: first the "
       "difference, then 2 pi",
       [](const Case& c) {
         return Numbers{c.expected + std::remainder(turn, c.measured - c.expected)};
       }},
      {"the remainder belongs to `expected`: expected + remainder(measured - expected, 2 pi)",
       [](const Case& c) {
         return Numbers{c.measured + std::remainder(c.measured - c.expected, turn)};
       }},
      {"#abs no absolute value: the remainder has a sign", [](const Case& c) {
         return Numbers{c.expected + std::abs(std::remainder(c.measured - c.expected, turn))};
       }},
      {"#without-expected `expected` is not added again after std::remainder",
       [](const Case& c) { return Numbers{std::remainder(c.measured - c.expected, turn)}; }},
      {"remainder of measured alone: expected + remainder(measured - expected, 2 pi)",
       [](const Case& c) { return Numbers{c.expected + std::remainder(c.measured, turn)}; }},
      {"the sign: expected + remainder(measured - expected, 2 pi)",
       [](const Case& c) {
         return Numbers{c.expected - std::remainder(c.measured - c.expected, turn)};
       }},
      {"measured and expected are exchanged",
       [](const Case& c) {
         return Numbers{c.measured + std::remainder(c.expected - c.measured, turn)};
       }},
      {"the angle is folded into (-pi, pi]: it must be the one nearest to `expected`",
       [](const Case& c) { return Numbers{std::remainder(c.measured, turn)}; }},
      {"the angle is folded into (-pi, pi]: it must be the one nearest to `expected`",
       [](const Case& c) { return Numbers{std::remainder(c.expected, turn)}; }}};
  for (const double pi : {3.14, 3.142, 3.1416, 3.14159, 3.141593, double(3.14159265f)})
    table.mistakes.push_back({"#3-14159 pi with too few digits: std::numbers::pi_v<real>",
                              plus(2 * pi, nearest)});
  for (const double k : {0, 1, -1, 2, -2, 7, -7, 60, -60})
    for (const double measured : {-3.1, -1.2, 0.4, 3.0, 4.2})
      for (const double off : {-2.9, -0.5, 0.2, 3.0}) {
        const double expected = std::round(100 * (measured + turn * k + off)) / 100;
        table.cases.push_back({short_number(measured) + " near " + short_number(expected),
                               measured, expected});
      }
  table.tolerance = is_float ? 1e-3 : 1e-9;
  table.leave_out_harmless();
  return table;
}

}  // namespace joints::testing
