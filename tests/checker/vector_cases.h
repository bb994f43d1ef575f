// Tables whose numbers are vectors, three after three: an entry is one of them.
#pragma once

#include "tests/checker/cases.h"

namespace joints::testing {

inline Numbers flat(const std::vector<vec3>& vectors) {
  Numbers out;
  for (const vec3& a : vectors) out.insert(out.end(), {double(a.x), double(a.y), double(a.z)});
  return out;
}

/// One case of a table whose numbers are vectors, three after three; an entry is one of them.
template <class Case>
void check_vectors(const CaseTable<Case>& table, const Case& c, const Numbers& expected,
                   double tolerance) {
  const Numbers numbers = table.yours(c);
  const auto at = [](const Numbers& a, std::size_t k) {
    return vec3(real(a[3 * k]), real(a[3 * k + 1]), real(a[3 * k + 2]));
  };
  std::vector<std::string> likely;
  if (!close(numbers, expected, tolerance)) likely = table.likely({c});
  const std::string arguments = table.given ? table.given(c) : "";
  Subject about = table.subject;
  about.given = arguments.c_str();
  for (std::size_t k = 0; k < table.entries.size(); ++k) {
    std::vector<VectorSuspect> suspects;
    for (const std::string& words : likely) suspects.push_back({at(numbers, k), words});
    expect(about, table.entries[k] + " (" + c.words + ")", at(numbers, k),
           at(expected, k), tolerance, suspects);
  }
}
template <class Case>
void check_vectors(const CaseTable<Case>& table) {
  for (const Case& c : table.cases) check_vectors(table, c, table.right(c), table.tolerance);
}

/// For a test of another kind: whatever vector it finds wrong, the table's mistake explains it.
template <class Case>
std::vector<VectorSuspect> why(const CaseTable<Case>& table, const vec3& yours) {
  std::vector<VectorSuspect> out;
  for (const std::string& words : table.likely()) out.push_back({yours, words});
  return out;
}

}  // namespace joints::testing
