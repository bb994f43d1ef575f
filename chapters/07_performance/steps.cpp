// Chapter 7's program, the steps of the loop. Read it; there is nothing to edit here.
#include "chapters/07_performance/program.h"

namespace joints::chapter7 {

void steps(const Choice&, std::vector<Summary>&) {}

}  // namespace joints::chapter7
