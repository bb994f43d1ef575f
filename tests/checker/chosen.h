// Which of a chapter's known answers a program runs: the one that WORKBOOK_ANSWER names, or else
// the solution. tools/check/answers.py makes the source that asks.
#pragma once

#include <initializer_list>

namespace joints::testing {

/// The place of the name in WORKBOOK_ANSWER; -1 where the variable is not set. Ends the program
/// with status 97 where no name fits.
int chosen_answer(std::initializer_list<const char*> names);

/// \throws std::logic_error that names the answer: it has ended without a return.
[[noreturn]] void no_return(const char* place);

}  // namespace joints::testing
