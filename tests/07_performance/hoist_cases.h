// Exercise 7.1 as tables of cases: levers, axis rows, inverse inertias and biases.
#pragma once

#include "tests/07_performance/loop_hinges.h"

namespace joints::testing {

using Hoist = void(const Hinge&, const Body&, const Body&, real, HingeNumbers<real>&);

/// Yours, or a mistake: a hoist of numbers that hold something else before.
inline HingeNumbers<real> hoisted(const HingeCase& c, Hoist* hoist = joints::hoist) {
  HingeNumbers<real> out;
  std::fill_n(reinterpret_cast<real*>(&out), sizeof out / sizeof(real), real(unwritten));
  hoist(c.hinge, c.pair.body1, c.pair.body2, c.h, out);
  return out;
}

/// A table of some of the numbers. \param part those of a HingeNumbers
template <class Part>
CaseTable<HingeCase> hoist_table(const char* what, const std::vector<std::string>& names,
                                 Part part) {
  CaseTable<HingeCase> table{{"7.1", what}, names, {}, {}, {}, hinge_cases()};
  judge(table, joints::hoist,
        [=](Hoist* hoist, const HingeCase& c) { return part(hoisted(c, hoist)); });
  table.right = [=](const HingeCase& c) { return part(reference_numbers(c)); };
  table.tolerance = 10 * rounding;
  table.in_pairs = true;
  return table;
}

inline CaseTable<HingeCase> lever_table() {
  return hoist_table("the levers of a hinge", with_xyz({"r1", "r2"}), [](const auto& numbers) {
    Numbers out;
    append(out, numbers.r1);
    append(out, numbers.r2);
    return out;
  });
}

inline CaseTable<HingeCase> axis_row_table() {
  const auto part = [](const HingeNumbers<real>& numbers) {
    Numbers out;
    for (const Triple<real>& row : numbers.axis_row) append(out, row);
    return out;
  };
  CaseTable<HingeCase> table = hoist_table("the axis rows of a hinge",
                                           with_xyz({"axis_row[0]", "axis_row[1]"}), part);
  // the slopes of the last two errors as body 2 turns
  table.right = [=](const HingeCase& c) {
    const Jacobian<5> J = numeric_jacobian(c.hinge, c.pair.body1, c.pair.body2);
    HingeNumbers<real> numbers{};
    numbers.axis_row = {triple(J[3].w2), triple(J[4].w2)};
    return part(numbers);
  };
  table.tolerance = difference_tolerance;
  return table;
}

inline constexpr const char* inertia_entries[] = {"xx", "yy", "zz", "xy", "xz", "yz"};
inline Numbers six_numbers(const Symmetric<real>& m) {
  return {double(m.xx), double(m.yy), double(m.zz), double(m.xy), double(m.xz), double(m.yz)};
}

inline CaseTable<HingeCase> inertia_table() {
  std::vector<std::string> names;
  for (const char* body : {"I1.", "I2."})
    for (const char* entry : inertia_entries) names.push_back(std::string(body) + entry);
  return hoist_table("the inverse inertias of a hinge's bodies", names, [](const auto& numbers) {
    Numbers out = six_numbers(numbers.I1);
    for (const double number : six_numbers(numbers.I2)) out.push_back(number);
    return out;
  });
}

inline CaseTable<HingeCase> hinge_bias_table() {
  return hoist_table("the biases of a hinge",
                     {"bias[0]", "bias[1]", "bias[2]", "bias[3]", "bias[4]"},
                     [](const auto& numbers) {
                       return Numbers(numbers.bias.begin(), numbers.bias.end());
                     });
}

}  // namespace joints::testing
