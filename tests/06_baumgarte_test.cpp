// Chapter 6.
#include "chapters/06_baumgarte/baumgarte.h"
#include "tests/catch.h"

TEST_CASE("6.1 placeholder", "[6.1]") { CHECK(joints::bias(1, 1, 1) == 1); }
