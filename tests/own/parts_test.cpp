// Parts that belong to no exercise, against the numeric checker.
#include "tests/catch.h"
#include "tests/fixtures.h"

using namespace joints;
using namespace joints::testing;

TEST_CASE("a rope's row is the slope of its slack at every pose") {
  check_jacobian<RopeFixture>();
  check_K<RopeFixture>();
}
