// Tables whose cases are poses and whose answers are many numbers: the report shows all that are
// wrong in a case, and in which others they hold.
#pragma once

#include "checker/report.h"
#include "tests/checker/cases.h"

namespace joints::testing {

/// One case: every number that is wrong beside the one that is right, at which poses the others of
/// the table hold, and the likely mistake. \param beside the name of the right number
/// \param more further lines, after the numbers
template <class Case>
void check_numbers(const CaseTable<Case>& table, const Case& c, const Numbers& expected,
                   const char* beside, const std::string& more = "") {
  table.check_numbers(c, expected, beside, more);
}
inline void check_numbers(const AnyTable& table) { table.check_all_numbers(); }

inline void append(Numbers& out, const vec3& a) {
  out.insert(out.end(), {double(a.x), double(a.y), double(a.z)});
}
/// "r1.x", "r1.y", "r1.z" of every name.
inline std::vector<std::string> with_xyz(const std::vector<std::string>& names) {
  std::vector<std::string> out;
  for (const std::string& name : names)
    for (const char* part : {".x", ".y", ".z"}) out.push_back(name + part);
  return out;
}

}  // namespace joints::testing
