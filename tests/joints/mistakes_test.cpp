// The usual mistakes that the tests of chapters 3 and 4 know: each is found out, and called by its
// name.
#include "tests/03_hinge/angle_cases.h"
#include "tests/03_hinge/axis_cases.h"
#include "tests/03_hinge/coupling_cases.h"
#include "tests/03_hinge/limit_cases.h"
#include "tests/03_hinge/motor_cases.h"
#include "tests/03_hinge/turns_cases.h"
#include "tests/04_slider/line_cases.h"
#include "tests/04_slider/lock_cases.h"
#include "tests/checker/named.h"

using namespace joints;
using namespace joints::testing;

TEST_CASE("each usual mistake in the rows of a hinge is found out and called by its name") {
  each_row_is_named<AxisFixture>();
  each_row_is_named<HingeAngleFixture>();
}

TEST_CASE("each usual mistake of chapter 3 is found out and called by its name") {
  each_is_named(axis_table());
  each_is_named(coupling_table());
  each_is_named(angle_table());
  each_is_named(turns_table());
  each_is_named(limit_table());
  each_is_named(motor_table());
}

TEST_CASE("each usual mistake of chapter 4 is found out and called by its name") {
  each_is_named(line_table());
  each_is_named(lock_table());
  each_is_named(slide_table());
}

TEST_CASE("a right answer of chapters 3 and 4 is blamed on no usual mistake") {
  none_is_blamed(axis_table());
  none_is_blamed(coupling_table());
  none_is_blamed(angle_table());
  none_is_blamed(turns_table());
  none_is_blamed(limit_table());
  none_is_blamed(motor_table());
  none_is_blamed(line_table());
  none_is_blamed(lock_table());
  none_is_blamed(slide_table());
}
