// The usual mistakes, tested themselves: each is found out and called by its own name and by no
// other, and a right answer is blamed on none.
#pragma once

#include "tests/checker/catch.h"
#include "tests/checker/cases.h"

namespace joints::testing {

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

// In float some mistakes cannot be told apart; a reader's file is compiled in double.
template <class... Case>
void are_sound(const CaseTable<Case>&... tables) {
  if constexpr (!is_float) (each_is_named(tables), ...);
  (none_is_blamed(tables), ...);
}

}  // namespace joints::testing
