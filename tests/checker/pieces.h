// Mistakes that change one piece of the right answer: the path to an answer is taken apart into a
// struct, the reference, and each mistake is one change of it. A table gets every mistake by itself
// and, where none of them explains your numbers, every two of them together.
#pragma once

#include "tests/checker/cases.h"

namespace joints::testing {

template <class Reference>
using Pieces = std::vector<Mistake<Call<void(Reference&)>>>;

/// What another mistake of the table gives already keeps the other's name.
/// \param reference of a case \param answer what a reference comes to
template <class Case, class Make, class Answer, class Reference>
void add_pieces(CaseTable<Case>& table, const Make& reference, const Answer& answer,
                const Pieces<Reference>& pieces) {
  const auto changed = [=](const std::vector<Call<void(Reference&)>>& changes) {
    return [=](const Case& c) {
      Reference one = reference(c);
      for (const auto& change : changes) change(one);
      return answer(one);
    };
  };
  for (const auto& [words, change] : pieces)
    if (const auto mistake = changed({change}); !table.knows(mistake))
      table.mistakes.push_back({words, mistake});
  table.pairs = [=] {
    typename CaseTable<Case>::Mistakes out;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (std::size_t j = i + 1; j < pieces.size(); ++j)
        out.push_back({pieces[i].words + "; and " + pieces[j].words,
                       changed({pieces[i].does, pieces[j].does})});
    return out;
  };
}

}  // namespace joints::testing
