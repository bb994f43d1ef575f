// Exercise 5.1: the block X between point and lock at every pose as a table.
#pragma once

#include "tests/checker/joint_fixtures.h"
#include "tests/checker/pose_cases.h"

namespace joints::testing {

struct CrossCase {
  std::string words;
  Point point;
  Pair pair;
};

/// The pose for pencil and paper in the chapter's text.
inline CrossCase paper_weld() {
  const real half = std::sqrt(real(0.5));  // cos 45 degrees
  return {"pencil and paper",
          {vec3(0), vec3(1, 0, real(0.5))},
          {static_body(vec3(0)), body_with(2, vec3(real(0.4), real(0.5), real(0.4)), vec3(0, -1, 0),
                                           quat(half, 0, 0, half))}};
}
inline std::vector<CrossCase> cross_cases() {
  std::vector<CrossCase> out;
  for_each_pose<PointFixture>([&](int pose, const Point& point, const Pair& pair) {
    out.push_back({pose_names[std::size_t(pose)], point, pair});
  });
  for (const char* words : {"1 static", "2 static"}) {
    out.push_back(out[9]);
    out.back().words = words;
    Body& wall = words[0] == '1' ? out.back().pair.body1 : out.back().pair.body2;
    wall = static_body(wall.x, wall.q);
  }
  return out;
}

/// J_t M^-1 J_r^T, entry by entry, with J_t the slopes of the gap and J_r = (0, -E, 0, E).
inline mat3 product_X(const CrossCase& c) {
  const Jacobian<3> J = numeric_jacobian(c.point, c.pair.body1, c.pair.body2);
  const mat3 I1 = inverse_inertia(c.pair.body1), I2 = inverse_inertia(c.pair.body2);
  mat3 X;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      X[column][row] = dot(J[row].w2, I2[column]) - dot(J[row].w1, I1[column]);
  return X;
}
inline Numbers row_after_row(const mat3& X) {
  Numbers out;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) out.push_back(double(X[column][row]));
  return out;
}

inline CaseTable<CrossCase> cross_table() {
  std::vector<std::string> entries;
  for (const char row : {'x', 'y', 'z'})
    for (const char column : {'x', 'y', 'z'})
      entries.push_back(std::string("X[") + row + ", " + column + "]");
  CaseTable<CrossCase> table{{"5.1", "the block X between point and lock"}, entries, {}, {}, {},
                             cross_cases()};
  judge(table, cross_K, [](auto cross, const CrossCase& c) {
    return row_after_row(cross(c.point, c.pair.body1, c.pair.body2));
  });
  table.right = [](const CrossCase& c) { return row_after_row(product_X(c)); };
  table.tolerance = K_tolerance;
  return table;
}

}  // namespace joints::testing
