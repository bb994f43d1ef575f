// The units of chapter 4's exercises.
#include "chapters/04_slider/slider.h"
#include "tests/checker/units.h"

using namespace joints;
using namespace joints::testing;

TEST_CASE("4.1 the error of a line is a length", "[4.1]") {
  has_unit("C", m, [] { return Line{lever1, lever2}.error(body1, body2); });
}

TEST_CASE("4.1 the rows of a line have arms for the turns", "[4.1]") {
  row_has_units("J", pure, m, [] { return Line{lever1, lever2}.jacobian(body1, body2); });
}

TEST_CASE("4.2 a lock has pure numbers in its error and in its rows", "[4.2]") {
  has_unit("C", pure, [] { return RotationLock{}.error(body1, body2); });
  row_of_turns_has_units("J", pure, [] { return RotationLock{}.jacobian(body1, body2); });
}

TEST_CASE("4.3 the displacement along a line is a length", "[4.3]") {
  has_unit("C", m, [] { return Slide{lever1, lever2}.error(body1, body2); });
}

TEST_CASE("4.3 the row of a displacement has levers for the rotations", "[4.3]") {
  row_has_units("J", pure, m, [] { return Slide{lever1, lever2}.jacobian(body1, body2); });
}
