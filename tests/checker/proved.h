// How much a program has proved, for the summary of ./wb check.
#pragma once

namespace joints::testing {

/// Adds to the count of proved things, such as "Jacobians". At the end of the program every count
/// is appended to the file that WORKBOOK_COUNTS names, a line each.
void proved(const char* what, long how_many = 1);

}  // namespace joints::testing
