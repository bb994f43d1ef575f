// Exercise 2.3: the impulse of a block of three rows, and its effect. Cases.
#pragma once

#include <numbers>

#include "chapters/02_ball/ball.h"
#include "tests/checker/impulse_cases.h"
#include "tests/checker/push_cases.h"

namespace joints::testing {

// The pose for pencil and paper in the chapter's text.
inline constexpr real half_root = real(std::numbers::sqrt2 / 2);  // cos 45 degrees
inline const Body ball_paper1 = static_body(vec3(0));
inline const Body ball_paper2 = [] {
  Body body = body_with(2, vec3(5 / real(6), 1, 5 / real(21)), vec3(0, -1, 0),
                        quat(half_root, 0, 0, half_root));
  body.v = vec3(1, 0, 0);
  body.w = vec3(0, 0, 2);
  return body;
}();

// Two moving bodies with three rows between them, and their K.
struct Joint3 {
  Pair pair = uneven_pair();
  Jacobian<3> J;

  Joint3() {
    Random random(3);
    move_together(pair, random);
    for (Body* body : {&pair.body1, &pair.body2}) {
      body->v = random.vector(2);
      body->w = random.vector(2);
    }
  }
  /// A ball joint, from the numeric reference, so that this exercise waits for no other.
  static Joint3 ball() {
    Joint3 out;
    const Point part = point_at(out.pair.body1, out.pair.body2, vec3(real(0.6), real(0.9), 1));
    out.J = numeric_jacobian(part, out.pair.body1, out.pair.body2);
    return out;
  }
  /// Rows of no joint in particular: no block is known beforehand.
  static Joint3 any() {
    Joint3 out;
    Random random(8);
    for (Row& row : out.J.row)
      for (vec3* block : {&row.v1, &row.w1, &row.v2, &row.w2}) *block = random.vector(1);
    return out;
  }
  mat3 K() const {
    const Matrix<3> dense = dense_K(J, pair.body1, pair.body2);
    mat3 out;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) out[j][i] = dense[i][j];
    return out;
  }
  vec3 rate() const {
    return {row_velocity(J[0], pair.body1, pair.body2), row_velocity(J[1], pair.body1, pair.body2),
            row_velocity(J[2], pair.body1, pair.body2)};
  }
  std::vector<Row> rows() const { return {J[0], J[1], J[2]}; }
};

inline std::vector<real> row_after_row(const mat3& K, real factor = 1) {
  std::vector<real> out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out.push_back(factor * K[j][i]);
  return out;
}

inline CaseTable<LackCase> block_impulse_table() {
  const Pair paper{ball_paper1, ball_paper2};
  const Joint3 ball = Joint3::ball(), any = Joint3::any();
  Joint3 light = any;
  for (Body* body : {&light.pair.body1, &light.pair.body2}) body->v = body->w = vec3(0);
  Pair hung = any.pair;
  hung.body1 = static_body(hung.body1.x, hung.body1.q);
  CaseTable<LackCase> table = lack_table(
      {"2.3", "the impulse of a block"}, {"lambda.x", "lambda.y", "lambda.z"},
      block_impulse, [](auto impulse, const LackCase& c) {
        mat3 K;
        for (int i = 0; i < 9; ++i) K[i % 3][i / 3] = c.K[std::size_t(i)];
        const vec3 lambda =
            impulse({{c.J[0], c.J[1], c.J[2]}}, K,
                    vec3(real(c.b[0]), real(c.b[1]), real(c.b[2])), c.pair.body1, c.pair.body2);
        return Numbers{double(lambda.x), double(lambda.y), double(lambda.z)};
      });
  const Jacobian<3> J = jacobian_from_blocks(mat3(-1), mat3(0), mat3(1),
                                             -skew(vec3(0, 1, real(0.5))));
  const Numbers none{0, 0, 0}, bias{0.3, -0.2, 0.5}, tiny{0.3e-9, -0.2e-9, 0.5e-9};
  table.cases = {
      {"Numbers, in the text", {J[0], J[1], J[2]},
       {5, 0, 0, 0, real(0.75), real(-0.5), 0, real(-0.5), real(1.5)}, none, paper},
      {"a ball joint with a gap", ball.rows(), row_after_row(ball.K()), bias, ball.pair},
      {"a ball joint without a gap", ball.rows(), row_after_row(ball.K()), none, ball.pair},
      {"rows of another joint", any.rows(), row_after_row(any.K()), bias, any.pair},
      {"bodies at rest", light.rows(), row_after_row(light.K()), bias, light.pair},
      {"body 1 is static", any.rows(), row_after_row(any.K()), bias, hung},
      {"J V + b of nm/s, lambda in 1e-9 N s", light.rows(), row_after_row(light.K()), tiny,
       light.pair, 1e-9},
      {"heavy bodies, K of 1e-9 / kg, lambda in 1e9 N s", any.rows(),
       row_after_row(any.K(), real(1e-9)), bias, any.pair, 1e9},
  };
  if (!is_float)  // a float cannot hold the determinant
    table.cases.push_back({"heavier bodies, K of 1e-20 / kg, lambda in 1e20 N s", any.rows(),
                           row_after_row(any.K(), real(1e-20)), bias, any.pair, 1e20});
  return table;
}

inline CaseTable<PushCase> block_push_table() {
  const Joint3 ball = Joint3::ball(), any = Joint3::any();
  Pair hung = any.pair, light = any.pair;
  hung.body1 = static_body(any.pair.body1.x, any.pair.body1.q);
  for (Body* body : {&light.body1, &light.body2}) {
    body->inverse_mass *= real(1e9);
    body->inverse_inertia_local *= real(1e9);
  }
  const Jacobian<3> J = jacobian_from_blocks(mat3(-1), mat3(0), mat3(1),
                                             -skew(vec3(0, 1, real(0.5))));
  const std::vector<real> lambda{real(0.4), real(-0.7), real(0.2)};
  void (*const push)(const Jacobian<3>&, const vec3&, Body&, Body&) = apply_impulse;
  return push_table(
      {"2.3", "applying the impulse of a block", 2},
      push, [](auto apply, const PushCase& c, Pair& pair) {
        apply({{c.J[0], c.J[1], c.J[2]}}, vec3(c.lambda[0], c.lambda[1], c.lambda[2]), pair.body1,
              pair.body2);
      },
      {{"Numbers, in the text", {J[0], J[1], J[2]}, {real(0.2), 0, 0}, {ball_paper1, ball_paper2}},
       {"a ball joint, lambda = (0.4, -0.7, 0.2) N s", ball.rows(), lambda, ball.pair},
       {"rows of another joint, lambda = (0.4, -0.7, 0.2) N s", any.rows(), lambda, any.pair},
       {"rows of another joint, lambda = (0, -0.7, 0) N s", any.rows(), {0, real(-0.7), 0},
        any.pair},
       {"rows of another joint, lambda = (-1, -2, -3) N s", any.rows(), {-1, -2, -3}, any.pair},
       {"body 1 is static", any.rows(), lambda, hung},
       {"bodies of a microgram, lambda = (2, 1, 3) 1e-9 N s", any.rows(),
        {real(2e-9), real(1e-9), real(3e-9)}, light}});
}

}  // namespace joints::testing
