// Exercises 2.1 to 2.4: cases drawn over scales, sides and angles.
#pragma once

#include "chapters/02_ball/ball.h"
#include "tests/checker/drawn.h"
#include "tests/checker/push_cases.h"
#include "tests/checker/unit_rates.h"
#include "tests/checker/vector_cases.h"

namespace joints::testing {

/// A ball joint with levers of any length.
inline Drawn drawn_point(Draw& d, bool of_K) {
  const Draw::Units u = d.units(12);
  Pair pair = d.pair(u);
  const auto [anchor1, anchor2] = d.levers(u);
  Point point{anchor1, anchor2};
  if (d.chance("the joint is closed")) {
    pair.body2.x = pair.body1.x, pair.body2.q = pair.body1.q;
    point.anchor2_local = anchor1;
  }
  const vec3 r1 = pair.body1.q * point.anchor1_local, r2 = pair.body2.q * point.anchor2_local;
  const Jacobian<3> J = point_by_rates(r1, r2);
  if (of_K) return drawn_K(d, to_matrix(point.K(pair.body1, pair.body2)), J, pair, u.kg);
  return drawn_rows(point.jacobian(pair.body1, pair.body2), J, double(length(r1)),
                    double(length(r2)));
}

inline Jacobian<3> drawn_point_rows(Draw& d, const Draw::Units& u) {
  const vec3 r1 = d.vector(u.m), r2 = d.vector(u.m);
  return point_by_rates(r1, r2);
}

/// Instead of lambda: K lambda beside the rates that it must take away.
inline Drawn drawn_block_impulse(Draw& d) {
  const Draw::Units u = d.units();
  Pair pair = d.pair(u);
  if (pair.body1.is_static() && pair.body2.is_static()) pair.body1.inverse_mass = real(1 / u.kg);
  const Jacobian<3> J = drawn_point_rows(d, u);
  const Matrix<3> K = dense_K(J, pair.body1, pair.body2);
  mat3 as_mat3;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) as_mat3[j][i] = K[i][j];
  const vec3 bias = d.vector(u.m / u.s);
  d.side("a bias is negative", std::min({bias.x, bias.y, bias.z}) < 0);
  const vec3 lambda = block_impulse(J, as_mat3, bias, pair.body1, pair.body2);
  const vec3 gone = as_mat3 * lambda;
  Drawn out{{}, {}, {}, {50}};
  for (int i = 0; i < 3; ++i) {
    out.entries.push_back(std::string("K lambda, row ") + "xyz"[i]);
    out.yours.push_back(double(gone[i]) * u.s / u.m);
    const double rate = double(row_velocity(J[i], pair.body1, pair.body2) + bias[i]);
    out.right.push_back(-rate * u.s / u.m);
  }
  return out;
}

inline Drawn drawn_block_push(Draw& d) {
  const Draw::Units u = d.units();
  PushCase c{"", {}, {}, d.pair(u)};
  vec3 lambda = d.vector(d.size("|lambda|", u.kg * u.m / u.s, "N s"));
  if (d.chance("a component of lambda is 0")) lambda[int(2.99 * d.pick())] = 0;
  d.side("a component of lambda is negative", std::min({lambda.x, lambda.y, lambda.z}) < 0);
  const Jacobian<3> J = drawn_point_rows(d, u);
  for (int i = 0; i < 3; ++i) c.J.push_back(J[i]), c.lambda.push_back(lambda[i]);
  Pair pair = c.pair;
  apply_impulse(J, lambda, pair.body1, pair.body2);
  return drawn_vectors({"v1", "w1", "v2", "w2"}, numbers_of(pair), pushed(c),
                       {u.m / u.s, 1 / u.s});
}

/// The rotation from the old orientation to the new one, in units of sin(angle / 2) of a small one.
inline Drawn drawn_rotation(Draw& d) {
  const real h = real(d.size("h", d.scale(), "s"));
  const double turns = d.chance("more than a turn") ? 30 : 0;
  const double angle = d.size("angle", turns + d.angle(), "rad");
  const vec3 axis = normalize(d.vector());
  const quat q = d.turn();
  const quat mine = turned(q, real(angle) / h * axis, h) * conjugate(q);
  const quat right = rotation(real(angle) * axis);
  const double sign = dot(mine, right) < 0 ? -1 : 1, unit = std::min(1.0, std::abs(angle)) + 1e-30;
  return {{"cos(angle / 2)", "x", "y", "z of the axis times sin(angle / 2)"},
          {sign * double(mine.w), sign * double(mine.x) / unit, sign * double(mine.y) / unit,
           sign * double(mine.z) / unit},
          {double(right.w), double(right.x) / unit, double(right.y) / unit,
           double(right.z) / unit},
          {10 + 1e-5 / unit}};
}

}  // namespace joints::testing
