// Mistakes that change one piece of what is right: the path to an answer is taken apart into a
// struct, the twin, and each mistake is one change of it. A table gets every mistake by itself and,
// where none of them explains your numbers, every two of them together.
#pragma once

#include "tests/checker/cases.h"

namespace joints::testing {

template <class Twin>
using Pieces = std::vector<std::pair<std::string, std::function<void(Twin&)>>>;

/// What another mistake of the table gives already keeps the other's name.
/// \param twin of a case \param answer what a twin comes to
template <class Case, class Make, class Answer, class Twin>
void add_pieces(CaseTable<Case>& table, const Make& twin, const Answer& answer,
                const Pieces<Twin>& pieces) {
  const auto changed = [=](const std::vector<std::function<void(Twin&)>>& changes) {
    return [=](const Case& c) {
      Twin one = twin(c);
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
        out.push_back({pieces[i].first + "; and " + pieces[j].first,
                       changed({pieces[i].second, pieces[j].second})});
    return out;
  };
}

}  // namespace joints::testing
