// Exercise 8.1: the gap of a corner at every pose as a table.
#pragma once

#include "tests/08_ground/ground_cases.h"
#include "tests/checker/cases.h"

namespace joints::testing {

struct GapCase {
  std::string words;
  Corner corner;
  Pair pair;
};

/// What a corner's pose is called.
inline std::string corner_pose(int pose) {
  return pose == 3 ? CornerFixture::broken.name : pose_names[std::size_t(pose)];
}

/// Sharp corners and balls at every pose, and one of each over a static ground.
inline std::vector<GapCase> gap_cases() {
  std::vector<GapCase> out;
  const auto look = [&](const std::string& what) {
    return [&, what](int pose, const Corner& part, const Pair& pair) {
      out.push_back({what + corner_pose(pose), part, pair});
    };
  };
  for_each_pose<CornerFixture>(look("corner, "));
  for_each_pose<BallOnTopFixture>(look("ball, "));
  for (const std::size_t k : {std::size_t(14), out.size() - 1}) {
    out.push_back(out[k]);
    out.back().words = (k == 14 ? "corner, 1 static, " : "ball, 1 static, ") + corner_pose(3);
    Body& ground = out.back().pair.body1;
    ground = static_body(ground.x, ground.q);
  }
  return out;
}

inline CaseTable<GapCase> gap_table() {
  using Case = GapCase;
  CaseTable<Case> table{{"8.1", "the error C of a corner"}, {"C"}, {}, {}, {}, gap_cases()};
  judge(table, +[](const Corner& corner, const Body& body1, const Body& body2) {
    return corner.error(body1, body2);
  }, [](auto error, const Case& c) {
    return Numbers{double(error(c.corner, c.pair.body1, c.pair.body2))};
  });
  table.right = [](const Case& c) {
    return Numbers{double(gap(c.corner, c.pair.body1, c.pair.body2))};
  };
  table.tolerance = 10 * rounding;
  table.in_pairs = true;
  return table;
}

}  // namespace joints::testing
