// Tables whose cases are poses and whose answers are many numbers: the report shows all that are
// wrong in a case, and in which others they hold.
#pragma once

#include "checker/report.h"
#include "tests/checker/cases.h"

namespace joints::testing {

inline const char* const no_usual_mistake =
    "None of the usual mistakes explains it: compare it with the equation, entry by entry.\n";

/// The names of a list, each once, and in their order.
inline std::vector<std::string> once(const std::vector<std::string>& names) {
  std::vector<std::string> out;
  for (const std::string& name : names)
    if (std::find(out.begin(), out.end(), name) == out.end()) out.push_back(name);
  return out;
}

/// At which poses a table's numbers are wrong, and at which others all are right.
template <class Case>
std::string where_it_holds(const CaseTable<Case>& table) {
  std::vector<std::string> fails, holds;
  for (const Case& c : table.cases)
    (close(table.yours(c), table.right(c), table.tolerance) ? holds : fails).push_back(c.words);
  fails = once(fails);
  holds = once(holds);
  std::erase_if(holds, [&](const std::string& pose) {
    return std::find(fails.begin(), fails.end(), pose) != fails.end();
  });
  return fails.empty()   ? "Holds at all other poses.\n"
         : holds.empty() ? "Fails at " + joined(fails) + ".\n"
                         : "Fails at " + joined(fails) + "; holds at " + joined(holds) + ".\n";
}

/// One case: every number that is wrong beside the one that is right, at which poses the others of
/// the table hold, and the likely mistake. \param beside the name of the right number
/// \param more further lines, after the numbers
template <class Case>
void check_numbers(const CaseTable<Case>& table, const Case& c, const Numbers& expected,
                   const char* beside, const std::string& more = "") {
  const Numbers yours = table.yours(c);
  if (close(yours, expected, table.tolerance)) return check(table.subject, "");
  Table numbers(beside);
  for (std::size_t i = 0; i < expected.size(); ++i)
    if (!near(yours[i], expected[i], table.tolerance))
      numbers.entry(table.entries[i], yours[i], expected[i], table.tolerance);
  const std::vector<std::string> mistakes = table.likely({c});
  std::string words = no_number(yours);
  if (words.empty() && !mistakes.empty()) words = mistakes.front();
  fail(table.subject, "Pose: " + c.words + ".\n\n" + numbers.words() + more + "\n" +
                          where_it_holds(table) +
                          (words.empty() ? no_usual_mistake : likely(words)));
}
template <class Case>
void check_numbers(const CaseTable<Case>& table) {
  for (const Case& c : table.cases) check_numbers(table, c, table.right(c), "numeric ");
}

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
