// Rows and their impulse, exercises 1.3 (one row) and 2.3 (a block of three): which impulse they
// lack. The effect of the impulse is in push_cases.h.
#pragma once

#include "tests/checker/cases.h"

namespace joints::testing {

struct LackCase {
  std::string words;
  std::vector<Row> J;
  std::vector<real> K;  ///< row after row
  Numbers b;
  Pair pair;
  double unit = 1;  ///< lambda is shown in these [N s]

  /// J V + b of a row.
  double rate(std::size_t i) const {
    return double(row_velocity(J[i], pair.body1, pair.body2)) + b[i];
  }
  /// Eq. 1-8 and 2-7.
  Numbers lambda() const {
    const std::size_t n = b.size();
    std::vector<real> inverse = K;
    invert_symmetric(inverse.data(), int(n));  // of 0 it is 0
    Numbers out(n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) out[i] -= double(inverse[i * n + j]) * rate(j);
    return out;
  }
};

/// A table without cases. \param numbers (function, case) lambda that a function gives
template <class Function, class Measure>
CaseTable<LackCase> lack_table(const Subject& subject, std::vector<std::string> entries,
                               Function* yours, const Measure& numbers) {
  const auto shown = [](Numbers lambda, const LackCase& c) {
    for (double& a : lambda) a /= c.unit;
    return lambda;
  };
  CaseTable<LackCase> table{subject, std::move(entries)};
  judge(table, yours, [=](auto f, const LackCase& c) { return shown(numbers(f, c), c); });
  table.right = [=](const LackCase& c) { return shown(c.lambda(), c); };
  table.whole = true;
  table.in_pairs = true;
  table.tolerance = 1e2 * rounding;
  return table;
}

}  // namespace joints::testing
