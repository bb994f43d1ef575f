// The usual mistakes that the tests of chapter 3's exercises know: each is found out, and called by
// its name.
#include "tests/03_hinge/angle_cases.h"
#include "tests/03_hinge/axis_cases.h"
#include "tests/checker/catch.h"
#include "tests/03_hinge/drive_cases.h"
#include "tests/checker/named.h"

using namespace joints;
using namespace joints::testing;

namespace {

// The rows of a part: a fixture whose part has the rows of one of its mistakes.
template <class Fixture>
struct Mistaken : Fixture {
  struct Part : Fixture::Part {
    int which = 0;
    auto jacobian(const Body& body1, const Body& body2) const {
      return Fixture::mistakes(*this, {body1, body2})[which].second;
    }
  };
  static inline int which = 0;
  static Part make(const Pair& pair) { return {Fixture::make(pair), which}; }
};
template <class Fixture>
void each_row_is_named() {
  const Pair pair = uneven_pair();
  const int count = int(Fixture::mistakes(Fixture::make(pair), pair).size());
  for (int i = 0; i < count; ++i) {
    Mistaken<Fixture>::which = i;
    const std::string words = Fixture::mistakes(Fixture::make(pair), pair)[i].first;
    const std::string report =
        jacobian_report(row_names<Fixture>(), jacobian_samples<Mistaken<Fixture>>(),
                        difference_tolerance);
    INFO(words << "\n" << report);
    CHECK(report.find("Likely mistake: " + words) != report.npos);
  }
}

}  // namespace

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

TEST_CASE("a right answer of chapter 3 is blamed on no usual mistake") {
  none_is_blamed(axis_table());
  none_is_blamed(coupling_table());
  none_is_blamed(angle_table());
  none_is_blamed(turns_table());
  none_is_blamed(limit_table());
  none_is_blamed(motor_table());
}
