// Exercise 7.2 as a table of poses.
#pragma once

#include "tests/07_performance/loop_hinges.h"
#include "tests/checker/arguments.h"

namespace joints::testing {

inline Numbers numbers_of(const Matrix<5>& K) {
  Numbers out;
  for (int i = 0; i < 5; ++i) out.insert(out.end(), K[i].begin(), K[i].end());
  return out;
}
inline std::vector<std::string> names_of_K() {
  const char* const rows[] = {"C.x", "C.y", "C.z", "a1.b", "a1.c"};
  std::vector<std::string> out;
  for (const char* i : rows)
    for (const char* j : rows) out.push_back("K[" + std::string(i) + ", " + j + "]");
  return out;
}

/// The only part of K that is wrong, and what its numbers have in common; "" where several are.
inline std::string wrong_part(const CaseTable<HingeCase>& table) {
  const char* const parts[] = {"the point's 3x3", "the part between the point and the axis",
                               "the axis' 2x2"};
  std::vector<Compared> of[3];
  std::vector<std::string> wrong;
  for (std::size_t part = 0; part < 3; ++part) {
    for (const HingeCase& c : table.cases) {
      const Numbers yours = table.yours(c), right = table.right(c);
      of[part].emplace_back();
      for (std::size_t k = 0; k < 25; ++k) {
        if (std::size_t(k / 5 > 2) + std::size_t(k % 5 > 2) != part) continue;
        of[part].back().yours.push_back(yours[k]);
        of[part].back().right.push_back(right[k]);
      }
    }
    if (std::any_of(of[part].begin(), of[part].end(), [&](const Compared& c) {
          return !same_numbers(c.yours, c.right, table.tolerance);
        })) wrong.push_back(parts[part]);
  }
  if (wrong.size() != 1) return "";
  const std::vector<Compared>& cases = of[std::find(parts, parts + 3, wrong[0]) - parts];
  std::string out = common_pattern(std::vector<std::string>(cases[0].right.size()), cases,
                                   table.tolerance, true);
  if (const std::size_t all = out.find("all of it"); all != out.npos)
    return out.replace(all, 9, wrong[0]);
  return "none of the usual ones, but it is in " + wrong[0] + " alone";
}

inline CaseTable<HingeCase> whole_K_table() {
  CaseTable<HingeCase> table{{"7.2", "K of a hinge's five rows"}, names_of_K(), {}, {}, {},
                             hinge_cases()};
  judge(table, joints::whole_K, [](auto K, const HingeCase& c) {
    return numbers_of(
        K(reference_numbers(c), c.pair.body1.inverse_mass, c.pair.body2.inverse_mass));
  });
  // J M^-1 J^T, with J by differences of the five errors
  table.right = [](const HingeCase& c) {
    return numbers_of(dense_K(numeric_jacobian(c.hinge, c.pair.body1, c.pair.body2),
                              c.pair.body1, c.pair.body2));
  };
  table.tolerance = K_tolerance;
  table.in_pairs = true;
  read_off(table, [=] { return wrong_part(table); });
  return table;
}

}  // namespace joints::testing
