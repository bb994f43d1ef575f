// The tests of chapter 9's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include "chapters/09_direct/direct_solver.h"
#include "tests/checker/catch.h"

using namespace joints;

TEST_CASE("9.4 a pivot that is rounding error has no inverse", "[9.4]") {
  CHECK(inverse_pivot(2, 2) == 0.5);
  CHECK(inverse_pivot(1e-14, 2) == 0);
}
