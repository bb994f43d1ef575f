// The parts that no exercise asks for and whole joints, against the numeric checker.
#include "tests/checker/joint_fixtures.h"
#include "tests/oracle/test.h"

TEST_CASE("a rope's row is the slope of its slack at every pose") {
  check_jacobian<RopeFixture>();
  check_K<RopeFixture>();
}

TEST_CASE("the two rows of a hinge's axis are the slopes of its error and K is J M^-1 J^T") {
  check_jacobian<AxisFixture>();
  check_K<AxisFixture>();
}

TEST_CASE("the row of a hinge's angle is its slope at every misalignment and K is J M^-1 J^T") {
  check_jacobian<HingeAngleFixture>();
  check_K<HingeAngleFixture>();
}

TEST_CASE("the rows of a line are the slopes of its error and K is J M^-1 J^T") {
  check_jacobian<LineFixture>();
  check_K<LineFixture>();
}

TEST_CASE("the rows of a lock are the slopes of its error where it is zero and K is J M^-1 J^T") {
  check_jacobian<RotationLockFixture>();
  check_K<RotationLockFixture>();
}

TEST_CASE("the row of a displacement is its slope and K is J M^-1 J^T") {
  check_jacobian<SlideFixture>();
  check_K<SlideFixture>();
}

TEST_CASE("the five rows of a hinge are solved with the K of all five") {
  check_jacobian<HingeFixture>();
  check_K<HingeFixture>();
}

TEST_CASE("the five rows of a slider are solved with the K of all five") {
  check_jacobian<SliderFixture>();
  check_K<SliderFixture>();
}

TEST_CASE("the six rows of a weld are solved with the K of all six") {
  check_jacobian<WeldFixture>();
  check_K<WeldFixture>();
}
