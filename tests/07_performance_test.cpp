// The tests of chapter 7's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include "chapters/07_performance/hinge_loop.h"
#include "tests/catch.h"
#include "tests/check.h"

using namespace joints;
using namespace joints::testing;
