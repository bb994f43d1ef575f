// Tables whose cases are a few numbers: with a name for each of these, the formula that the
// reader's answer follows can be read off it, and numbers that were cut to whole ones are found.
#pragma once

#include "checker/report.h"
#include "tests/checker/cases.h"

namespace joints::testing {

template <class Case>
struct Argument {
  const char* name;
  double Case::*of;
  const char* unit = "";
};
template <class Case>
using Arguments = std::vector<Argument<Case>>;

/// "rate 2.88 m/s, mu 0.5"
template <class Case>
std::string arguments_of(const Case& c, const Arguments<Case>& arguments) {
  std::string out;
  for (const Argument<Case>& a : arguments)
    out += (out.empty() ? "" : ", ") + std::string(a.name) + " " + short_number(c.*a.of) +
           (*a.unit ? " " : "") + a.unit;
  return out;
}

/// "2 C beta / h": a number times powers of the arguments that is yours in all cases; "" where
/// there is none.
template <class Case>
std::string formula_of(const std::vector<Case>& cases, const Call<double(const Case&)>& yours,
                       const Arguments<Case>& arguments) {
  const auto same = [](double a, double b) {
    return std::abs(a - b) <= 1e-7 * (std::abs(a) + std::abs(b)) + 1e-12 ||
           (!std::isfinite(a) && !std::isfinite(b));
  };
  if (std::all_of(cases.begin(), cases.end(), [&](const Case& c) { return same(yours(c), 0); }))
    return "0";
  for (const Case& c : cases)
    if (no_number({yours(c)}) == never_set) return "";
  const double powers[] = {0, 1, -1, 2, -2, 0.5, -0.5};
  std::size_t count = 1;
  for (std::size_t k = 0; k < arguments.size(); ++k) count *= std::size(powers);
  for (std::size_t which = 0; which < count; ++which) {
    std::vector<double> power;
    for (std::size_t k = 0, rest = which; k < arguments.size(); ++k, rest /= std::size(powers))
      power.push_back(powers[rest % std::size(powers)]);
    const auto product = [&](const Case& c) {
      double out = 1;
      for (std::size_t k = 0; k < arguments.size(); ++k)
        if (power[k] != 0) out *= std::pow(c.*arguments[k].of, power[k]);
      return out;
    };
    double factor = 0;
    for (const Case& c : cases)
      if (const double a = product(c); factor == 0 && std::isfinite(a) && a != 0)
        factor = yours(c) / a;
    const auto fits = [&](const Case& c) { return same(yours(c), factor * product(c)); };
    if (factor == 0 || !std::all_of(cases.begin(), cases.end(), fits)) continue;
    std::string above, below;
    for (std::size_t k = 0; k < arguments.size(); ++k)
      if (power[k] != 0) {
        std::string& side = power[k] > 0 ? above : below;
        side += (side.empty() ? "" : " ") + std::string(arguments[k].name);
        if (std::abs(power[k]) != 1) side += "^" + short_number(std::abs(power[k]));
      }
    const bool several = below.find(' ') != std::string::npos;
    if (above.empty() || !same(factor, 1))
      above = same(factor, -1) && !above.empty()
                  ? "-" + above
                  : short_number(factor) + (above.empty() ? "" : " ") + above;
    return above + (below.empty() ? "" : several ? " / (" + below + ")" : " / " + below);
  }
  return "";
}

/// Where nothing explains the numbers: what can be read off them in words, "" where nothing can.
template <class Case>
void read_off(CaseTable<Case>& table, const Call<std::string()>& words) {
  table.pairs = [=, before = table.pairs, yours = table.yours] {
    typename CaseTable<Case>::Mistakes out;
    if (before) out = before();
    if (const std::string read = words(); !read.empty()) out.push_back({read, yours});
    return out;
  };
}

/// Mistakes that any formula can have: an argument, 1/h or the answer is cut to a whole number; and
/// where nothing explains the numbers, the formula that is yours.
template <class Case>
void add_formulas(CaseTable<Case>& table, const Arguments<Case>& arguments) {
  const char* const cut = " is cut to a whole number: an int has no fraction";
  const auto add = [&](const std::string& name, const auto& answer) {
    for (const Case& c : table.cases)
      if (!std::isfinite(answer(c)[0])) return;  // a division by zero, which is told anyway
    if (!table.knows(answer)) table.mistakes.push_back({name + cut, answer});
  };
  for (const Argument<Case>& a : arguments) {
    const auto with = [&](auto change) {
      return [=, right = table.right](const Case& c) {
        Case other = c;
        other.*a.of = change(c.*a.of);
        return right(other);
      };
    };
    add(a.name, with([](double x) { return std::trunc(x); }));
    if (a.name == std::string("h"))
      add("1/h", with([](double h) { return 1 / std::trunc(1 / h); }));
  }
  add("the answer", [right = table.right](const Case& c) {
    Numbers out = right(c);
    for (double& x : out) x = std::trunc(x);
    return out;
  });
  read_off(table, [=, yours = table.yours, cases = table.cases] {
    const auto number = [&](const Case& c) { return yours(c)[0]; };
    const std::string formula = formula_of<Case>(cases, number, arguments);
    return formula.empty() ? "" : "yours is " + formula + " in every case";
  });
}

}  // namespace joints::testing
