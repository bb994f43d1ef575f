// The usual mistakes that the tests of chapters 1 and 2 know: each is found out, and called by its
// name.
#include "tests/01_distance/clamp_cases.h"
#include "tests/01_distance/row_cases.h"
#include "tests/01_distance/step_cases.h"
#include "tests/02_ball/block_cases.h"
#include "tests/02_ball/rotation_cases.h"
#include "tests/checker/fixtures.h"
#include "tests/checker/named.h"

using namespace joints;
using namespace joints::testing;

namespace {

// In float some mistakes cannot be told apart; readers compute in double.
template <class Case>
void is_sound(const CaseTable<Case>& table) {
  if (!is_float) each_is_named(table);
  none_is_blamed(table);
}

}  // namespace

TEST_CASE("each usual mistake in the rows of a rod and a ball is called by its name") {
  each_row_is_named<CentreDistanceFixture>();
  each_row_is_named<DistanceFixture>();
  each_row_is_named<PointFixture>();
}

TEST_CASE("each usual mistake with an impulse is called by its name") {
  is_sound(row_impulse_table());
  is_sound(block_impulse_table());
  is_sound(row_push_table());
  is_sound(block_push_table());
  is_sound(clamp_table());
}

TEST_CASE("each usual mistake with one velocity is called by its name") {
  for (CaseTable<PushCase> table : {row_push_table(), block_push_table()}) {
    const std::size_t rows = table.cases[0].J.size();
    const char* const names[] = {"v1", "w1", "v2", "w2"};
    for (int block = 0; block < 4; ++block)
      for (const auto& [words, mistake] : velocity_mistakes(rows, block % 2 == 1)) {
        table.yours = [=, mistake = mistake](const PushCase& c) {
          Numbers out = pushed(c);
          const vec3 a = mistake({c, block >= 2});
          for (int i = 0; i < 3; ++i) out[3 * block + i] = double(a[i]);
          return out;
        };
        CHECK(velocity_by_velocity(table) == words + " (" + names[block] + ")");
      }
  }
}

TEST_CASE("each usual mistake in a step is called by its name") {
  std::vector<Scene> all = scenes_without_ropes();
  for (const Scene& scene : rope_scenes()) all.push_back(scene);
  CaseTable<Scene> table{{"1.4", "the step"}, step_entries(), stepped,
                         [](const Scene& s) { return walked(s); }, {}, all};
  table.whole = true;
  table.tolerance = 10 * rounding;
  for (const auto& [words, way] : step_mistakes())
    table.mistakes.push_back({words, [way = way](const Scene& s) { return walked(s, way); }});
  is_sound(table);
}

TEST_CASE("each usual mistake with a rotation is called by its name") {
  is_sound(rotation_table());
}
