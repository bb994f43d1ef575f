// Tables whose numbers are vectors, three after three: an entry is one of them.
#pragma once

#include "tests/checker/cases.h"
#include "tests/checker/drawn.h"

namespace joints::testing {

inline Numbers flat(const std::vector<vec3>& vectors) {
  Numbers out;
  for (const vec3& a : vectors) out.insert(out.end(), {double(a.x), double(a.y), double(a.z)});
  return out;
}

/// The rows of a part beside the right ones. \param lever1 unit of the blocks w1, lever2 of w2
template <int N>
Drawn drawn_rows(const Jacobian<N>& yours, const Jacobian<N>& right, double lever1,
                 double lever2) {
  std::vector<std::string> names;
  for (int i = 0; i < N; ++i)
    for (const char* block : {"v1", "w1", "v2", "w2"})
      names.push_back((N == 1 ? "J." : "J[" + std::to_string(i) + "].") + block);
  Drawn out = drawn_vectors(names, flat(yours), flat(right), {1, lever1, 1, lever2});
  out.sizes = {5};
  return out;
}
/// A part's K beside J M^-1 J^T. \param kg a unit
template <int N>
Drawn drawn_K(Draw& d, const Matrix<N>& yours, const Jacobian<N>& J, const Pair& pair, double kg) {
  const Matrix<N> right = dense_K(J, pair.body1, pair.body2);
  Drawn out;
  double size = 0;
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) {
      out.entries.push_back("kg K[" + std::to_string(i) + ", " + std::to_string(j) + "]");
      out.yours.push_back(kg * double(yours[i][j]));
      out.right.push_back(kg * double(right[i][j]));
      size = std::max(size, std::abs(out.right.back()));
    }
  d.size("K", size / kg, "1/kg");
  out.sizes = {20 * size};
  return out;
}

/// One case of a table whose numbers are vectors, three after three; an entry is one of them.
template <class Case>
void check_vectors(const CaseTable<Case>& table, const Case& c, const Numbers& expected,
                   double tolerance) {
  table.check_vectors(c, expected, tolerance);
}
inline void check_vectors(const AnyTable& table) { table.check_all_vectors(); }

/// For a test of another kind: whatever vector it finds wrong, the table's mistake explains it.
template <class Case>
std::vector<VectorSuspect> why(const CaseTable<Case>& table, const vec3& yours) {
  std::vector<VectorSuspect> out;
  for (const std::string& words : table.likely()) out.push_back({yours, words});
  return out;
}

}  // namespace joints::testing
