// The usual mistakes that the tests of chapters 5 to 8 know: each is found out, and called by its
// name.
#include "tests/05_fixed/break_cases.h"
#include "tests/05_fixed/cross_cases.h"
#include "tests/05_fixed/load_cases.h"
#include "tests/06_baumgarte/baumgarte_cases.h"
#include "tests/06_baumgarte/safety_cases.h"
#include "tests/06_baumgarte/torn_joints.h"
#include "tests/07_performance/colour_mistakes.h"
#include "tests/07_performance/hoist_bias_cases.h"
#include "tests/07_performance/solve_pieces.h"
#include "tests/07_performance/whole_K_cases.h"
#include "tests/08_ground/friction_cases.h"
#include "tests/08_ground/gap_cases.h"
#include "tests/08_ground/tangent_cases.h"
#include "tests/06_baumgarte/warm_cases.h"
#include "tests/checker/named.h"

using namespace joints;
using namespace joints::testing;

namespace {

template <class Case>
void is_sound(const CaseTable<Case>& table) {
  each_is_named(table);
  none_is_blamed(table);
}

}  // namespace

TEST_CASE("each usual mistake of chapter 5 is found out and called by its name") {
  is_sound(cross_table());
  is_sound(load_table());
  is_sound(about_table());
  is_sound(break_table());
}

TEST_CASE("each usual mistake of chapter 6 is found out and called by its name") {
  is_sound(bias_table());
  is_sound(limit_bias_table());
  is_sound(half_time_table());
  is_sound(warm_table());
  is_sound(safety_table());
  is_sound(point_table());
  is_sound(rope_table());
}

TEST_CASE("each usual mistake with colours gives other colours than the rest") {
  const std::vector<ColourScene> scenes = colour_scenes();
  std::vector<std::vector<Colours>> all;
  for (const ColourMistake& mistake : colour_mistakes()) {
    std::vector<Colours> of;
    bool right = true;
    for (const ColourScene& scene : scenes) {
      of.push_back(mistake.of(scene));
      right = right && of.back() == right_colours(scene);
    }
    INFO(mistake.words);
    CHECK(!right);
    for (std::size_t k = 0; k < all.size(); ++k) {
      INFO(colour_mistakes()[k].words);
      CHECK(all[k] != of);
    }
    all.push_back(of);
  }
}

TEST_CASE("each usual mistake of chapter 7 is found out and called by its name") {
  is_sound(lever_table());
  is_sound(axis_row_table());
  is_sound(inertia_table());
  is_sound(hinge_bias_table());
  is_sound(whole_K_table());
  for (const int part : {0, 1, 2}) is_sound(K_part_table(part));
  is_sound(solve_table());
}

TEST_CASE("each usual mistake of chapter 8 is found out and called by its name") {
  is_sound(gap_table());
  is_sound(tangent_table());
  is_sound(friction_table());
}
