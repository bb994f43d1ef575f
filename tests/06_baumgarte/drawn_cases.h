// Exercises 6.1 to 6.3: cases drawn over sizes, scales and sides.
#pragma once

#include "chapters/06_baumgarte/baumgarte.h"
#include "tests/06_baumgarte/torn_joints.h"
#include "tests/checker/drawn.h"
#include "tests/checker/push_cases.h"
#include "tests/checker/unit_rates.h"

namespace joints::testing {

inline Drawn drawn_bias(Draw& d, bool of_limit) {
  const double C = d.size("|C|", d.any_size(), "m"), h = d.size("h", d.scale(), "s");
  const double beta = d.chance("beta is small") ? std::pow(10, -12 * d.pick()) : d.pick();
  d.side("C is negative", C < 0);
  d.size("|C| / h", std::abs(C) / h, "m/s");
  d.size("beta |C| / h", beta * std::abs(C) / h, "m/s");
  const double yours = double((of_limit ? limit_bias : bias)(real(C), real(beta), real(h)));
  return {{"b h / |C|"}, {yours * h / std::abs(C)},
          {(of_limit && C > 0 ? 1 : beta) * (C < 0 ? -1 : 1)}, {1}};
}

inline Drawn drawn_beta(Draw& d) {
  const double half_time = d.size("half-time", d.scale(), "s"), steps = d.scale(6);
  const double h = half_time * d.size("h / half-time", steps, "");
  const double right = -std::expm1(-std::log(2.0) * steps);
  return {{"beta"}, {double(beta_for(real(half_time), real(h)))}, {right}, {right + 1e-6}};
}

inline Drawn drawn_warm_start(Draw& d) {
  const Draw::Units u = d.units();
  PushCase c{"", {}, {}, d.pair(u)};
  const double apart = d.scale(6), size = apart * u.kg * u.m / u.s;
  vec3 before = d.vector(size);
  if (d.chance("a component of lambda is 0"))
    for (int i = 0; i < 3; ++i) before[i] *= real(d.pick() < 0.5);
  d.side("a component of lambda is negative", std::min({before.x, before.y, before.z}) < 0);
  const double ratio = d.size("ratio", d.scale(2), "");
  d.size("|lambda|", double(length(before)), "N s");
  d.size("|ratio lambda|", ratio * double(length(before)), "N s");
  const std::array<vec3, 2> r = {d.vector(u.m), d.vector(u.m)};
  const Jacobian<3> J = point_by_rates(r[0], r[1]);
  for (int i = 0; i < 3; ++i) c.J.push_back(J[i]), c.lambda.push_back(real(ratio) * before[i]);
  Pair pair = c.pair;
  vec3 lambda = before;
  warm_start(J, real(ratio), lambda, pair.body1, pair.body2);
  Numbers yours = numbers_of(pair), right = pushed(c);
  yours.resize(12), right.resize(12);
  for (int i = 0; i < 3; ++i) {
    yours.push_back(double(lambda[i]) / size);
    right.push_back(double(c.lambda[std::size_t(i)]) / size);
  }
  Drawn out = drawn_vectors({"v1", "w1", "v2", "w2", "lambda in its unit"}, yours, right,
                            {u.m / u.s, 1 / u.s, u.m / u.s, 1 / u.s, 1});
  out.sizes.assign(12, 20 + 20 * ratio * apart);
  for (int i = 0; i < 3; ++i) out.sizes.push_back(20 * ratio);
  return out;
}

/// Just safe or just not, with up to a million iterations.
inline Drawn drawn_safety(Draw& d) {
  const int iterations = d.count("iterations", d.whole(1, is_float ? 1000 : 1000000));
  const double beta = d.chance("beta is 0") ? 0 : d.pick();
  const double beside = std::pow(10, -7 * d.pick()) / 2;
  const bool safe = d.chance("it is safe");
  d.size("distance to the bound", beside, "");
  const double product = safe ? 1 - beside : 1 + beside;
  const double rho = std::pow(product / (1 + beta), 1.0 / iterations);
  return {{"safe (1 yes)"}, {double(warm_start_is_safe(real(rho), iterations, real(beta)))},
          {double(safe)}, {1}};
}

/// The move of a body in units of the error, and its rotation.
inline void append_move(Drawn& out, const std::string& of, const Body& before, const Body& mine,
                        const Body& right, double C, double length) {
  for (const bool turns : {false, true})
    for (int i = 0; i < 3; ++i) {
      const auto move = [&](const Body& now) {
        return double(turns ? turn_between(before.q, now.q)[i] * real(length)
                            : now.x[i] - before.x[i]) / C;
      };
      out.entries.push_back((turns ? "rotation of " : "move of ") + of + "." + "xyz"[i]);
      out.yours.push_back(move(mine));
      out.right.push_back(move(right));
    }
}
/// A point or rope that is torn apart by little or much.
inline Drawn drawn_projection(Draw& d, bool of_rope) {
  const Draw::Units u = d.units();
  const double apart = d.size("|C|", u.m * std::pow(10, -10 * d.pick()) / 3, "m");
  Pair pair = d.pair(u);
  if (pair.body1.is_static()) pair.body2 = d.body(u);
  const vec3 anchor1 = d.vector(u.m), anchor2 = d.vector(u.m);
  const vec3 n = normalize(d.vector()), ends = pair.body1.x + to_world(pair.body1, anchor1);
  const double length = of_rope ? u.m : 0;
  const bool slack = of_rope && d.chance("the rope is slack");
  const real reach = real(length + (slack ? -apart : apart));
  pair.body2.x = ends + reach * n - to_world(pair.body2, anchor2);
  const Rope<Distance> rope{{anchor1, anchor2, real(length)}};
  const Point point{anchor1, anchor2};
  Pair mine = pair, right = pair;
  of_rope ? project(rope, mine.body1, mine.body2) : project(point, mine.body1, mine.body2);
  PushCase c{"", {}, {}, pair};
  for (Body* body : {&c.pair.body1, &c.pair.body2}) body->v = body->w = vec3(0);
  const auto solve = [&](const auto& part) {
    const auto J = to_jacobian(part.jacobian(pair.body1, pair.body2));
    auto K = dense_K(J, pair.body1, pair.body2);
    const auto C = to_vector(part.error(pair.body1, pair.body2));
    std::vector<real> inverse;
    const int rows = std::decay_t<decltype(part)>::rows;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < rows; ++j) inverse.push_back(K[i][j]);
    invert_symmetric(inverse.data(), rows);
    for (int i = 0; i < rows; ++i) {
      c.J.push_back(J[i]);
      c.lambda.push_back(0);
      for (int j = 0; j < rows; ++j) c.lambda.back() -= inverse[std::size_t(rows * i + j)] * C[j];
    }
  };
  if (of_rope && !slack) solve(rope);
  if (!of_rope) solve(point);
  const Numbers moves = pushed(c);
  const auto vector = [&](int at) {
    return vec3(real(moves[std::size_t(at)]), real(moves[std::size_t(at + 1)]),
                real(moves[std::size_t(at + 2)]));
  };
  for (Body* body : {&right.body1, &right.body2}) {
    const int at = body == &right.body1 ? 0 : 6;
    body->x += vector(at);
    body->q = normalize(rotation(vector(at + 3)) * body->q);
  }
  Drawn out{{}, {}, {}, {100 + 1e-5 * u.m / apart}};
  append_move(out, "body 1", pair.body1, mine.body1, right.body1, apart, u.m);
  append_move(out, "body 2", pair.body2, mine.body2, right.body2, apart, u.m);
  return out;
}

/// An iteration of a chain with the reader's own projection.
inline Drawn drawn_iteration(Draw& d) {
  const int joints = d.count("joints", d.whole(1, 300));
  const bool closed = d.chance("joints are closed already");
  const double decades = d.chance("joints are hardly open") ? 9 : 0;
  Random random = d.many();
  const auto chance = [&] { return double(random.uniform(0, 1)); };
  Chain chain{{static_body(vec3(0))}, {}};
  for (int k = 1; k <= joints; ++k) {
    const bool turned = !closed || chance() < 0.5;  // unturned bodies close a joint exactly
    Body body = body_with(1, vec3(real(0.2), real(0.5), real(0.6)), vec3(real(k), 0, 0),
                          turned ? random.turn() : quat(1, 0, 0, 0));
    chain.joints.push_back(point_at(chain.bodies.back(), body, vec3(real(k) - real(0.5), 0, 0)));
    const double gap = 0.1 * std::pow(10, -decades * chance());
    if (!closed || chance() < 0.5) body.x += random.vector(real(gap));
    chain.bodies.push_back(body);
  }
  Chain yours = chain, right = chain;
  projection_iteration(yours);
  project_in_order(right, project);
  Drawn out{{}, {}, {}, {0.01}};
  for (std::size_t k = 1; k < chain.bodies.size(); ++k)
    append_move(out, "body " + std::to_string(k), chain.bodies[k], yours.bodies[k],
                right.bodies[k], 1, 1);
  return out;
}

}  // namespace joints::testing
