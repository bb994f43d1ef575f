// The tables of mistakes in the exercises' tests: each mistake is found out, and called by its name.
#include "tests/angle_cases.h"
#include "tests/axis_cases.h"
#include "tests/catch.h"
#include "tests/drive_cases.h"

using namespace joints;
using namespace joints::testing;

namespace {

// An answer with the one mistake in the place of yours.
template <class Case>
void each_is_named(const CaseTable<Case>& table) {
  for (const auto& [words, answer] : table.mistakes) {
    CaseTable<Case> wrong = table;
    wrong.yours = answer;
    const std::vector<std::string> likely = wrong.likely();
    INFO(words);
    REQUIRE(!likely.empty());
    CHECK(likely.front() == words);
  }
}
// What is right is blamed on no mistake.
template <class Case>
void none_is_blamed(CaseTable<Case> table) {
  table.yours = table.right;
  CHECK(table.likely().empty());
}

}  // namespace

TEST_CASE("each usual mistake of chapter 3 is found out and called by its name") {
  each_is_named(axis_table());
  each_is_named(coupling_table());
  each_is_named(angle_table());
  each_is_named(turns_table());
  each_is_named(limit_table());
  each_is_named(motor_table());
}

TEST_CASE("a right answer of chapter 3 is blamed on no usual mistake") {
  none_is_blamed(axis_table());
  none_is_blamed(coupling_table());
  none_is_blamed(angle_table());
  none_is_blamed(turns_table());
  none_is_blamed(limit_table());
  none_is_blamed(motor_table());
}
