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

// A fixture whose part has the rows of one of its mistakes.
template <class Fixture>
struct Mistaken : Fixture {
  struct Part : Fixture::Part {
    int which = 0;
    auto jacobian(const Body& body1, const Body& body2) const {
      return Fixture::mistakes(*this, {body1, body2})[which].second;
    }
  };
  static inline int which = 0;
  static Part make(const Pair& pair) { return {Fixture::make(pair), which}; }
};
template <class Fixture>
void each_row_is_named() {
  const Pair pair = uneven_pair();
  const int count = int(Fixture::mistakes(Fixture::make(pair), pair).size());
  for (int i = 0; i < count; ++i) {
    Mistaken<Fixture>::which = i;
    const std::string words = Fixture::mistakes(Fixture::make(pair), pair)[i].first;
    const std::string report =
        jacobian_report(row_names<Fixture>(), jacobian_samples<Mistaken<Fixture>>(),
                        difference_tolerance);
    INFO(words << "\n" << report);
    CHECK(report.find("Likely mistake: " + words) != report.npos);
  }
}

}  // namespace joints::testing
