// Exercise 2.5: the free rotation of a body.
#pragma once

#include "chapters/02_ball/ball.h"
#include "engine/rotation/free_rotation.h"
#include "tests/checker/drawn.h"
#include "tests/checker/vector_cases.h"

namespace joints::testing {

inline constexpr Subject tumbling{"2.5", "the free rotation of a body"};

struct TumbleCase {
  std::string words;
  Body body;
  double h;
};

/// Eq. 2-11 with the rotations on the other side of q, about the body's axes as they are in it.
inline Body right_tumble(Body body, double h) {
  const vec3 moments = real(1) / body.inverse_inertia_local, L = angular_momentum(body);
  int most = 0, least = 2;
  for (int i = 0; i < 3; ++i) {
    if (moments[i] > moments[most]) most = i;
    if (moments[i] < moments[least]) least = i;
  }
  if (most == least) most = (least + 1) % 3;  // all are equal
  const int middle = 3 - most - least;
  vec3 in_body = conjugate(body.q) * L;
  const auto rotate = [&](int i, double by) {
    vec3 phi(0);
    phi[i] = real(by) * in_body[i] * (1 / moments[i] - 1 / moments[middle]);
    body.q = body.q * rotation(phi);
    in_body = conjugate(rotation(phi)) * in_body;
  };
  rotate(most, h / 2), rotate(least, h), rotate(most, h / 2);
  body.q = normalize(rotation(real(h) / moments[middle] * L) * body.q);
  set_angular_momentum(body, L);
  return body;
}

/// The numbers of a body as vectors: q without its first number, with w >= 0, and so on.
inline Numbers tumbled(const Body& before, const Body& after) {
  const quat moved = after.q * conjugate(before.q);
  const real sign = moved.w < 0 ? real(-1) : real(1);
  return flat({sign * vec3(moved.x, moved.y, moved.z), after.w,
               angular_momentum(after) - angular_momentum(before), after.x - before.x,
               after.v - before.v, vec3(length(after.q), 0, 0)});
}

inline Body spinning(const vec3& moments, const vec3& w, const quat& q = quat(1, 0, 0, 0)) {
  Body body = body_with(2, moments, vec3(1, -2, 3), q);
  body.v = vec3(real(0.5), 1, -1);
  body.w = w;
  return body;
}

inline CaseTable<TumbleCase> tumble_table() {
  using Case = TumbleCase;
  CaseTable<Case> table{tumbling,
                        {"axis sin(angle/2)", "w", "change of L", "change of x",
                         "change of v", "length of q"}, {}, {}, {}, {}};
  judge(table, tumble, [](auto does, const Case& c) {
    Body after = c.body;
    does(after, real(c.h));
    return tumbled(c.body, after);
  });
  table.right = [](const Case& c) { return tumbled(c.body, right_tumble(c.body, c.h)); };
  Random random(25);
  const vec3 uneven[] = {{real(1.0), real(0.7), real(0.4)}, {real(0.5), real(1.1), real(0.8)},
                         {real(0.9), real(0.35), real(0.6)}, {real(0.4), real(0.8), real(1.0)},
                         {real(0.7), real(0.3), real(0.95)}, {real(0.6), real(1.2), real(0.7)}};
  for (const vec3& moments : uneven)
    table.cases.push_back({"an uneven body", spinning(moments, random.vector(3), random.turn()),
                           0.1});
  table.cases.push_back({"a wheel", spinning({1, real(0.6), real(0.6)}, random.vector(3),
                                             random.turn()), 0.1});
  table.cases.push_back({"a rod", spinning({1, real(0.1), 1}, random.vector(3), random.turn()),
                         0.1});
  table.cases.push_back({"a ball", spinning(vec3(2), random.vector(3), random.turn()), 0.1});
  table.cases.push_back({"a body at rest", spinning(uneven[0], vec3(0), random.turn()), 0.1});
  table.tolerance = 100 * rounding;
  return table;
}

/// A body of any size and any speed, in any direction of time.
inline Drawn drawn_tumble(Draw& d) {
  const Draw::Units u = d.units();
  Body body = d.body(u);
  const int first = d.whole(0, 2);
  const vec3 given = body.inverse_inertia_local;
  for (int i = 0; i < 3; ++i) body.inverse_inertia_local[i] = given[(i + first) % 3];
  if (d.chance("two moments are equal"))
    body.inverse_inertia_local[1] = body.inverse_inertia_local[0];
  const double angle = d.size("angle", std::pow(10, 1 - 5 * d.pick()), "rad");
  const double sign = d.chance("h is negative") ? -1 : 1;
  const real h = real(sign * angle) / length(body.w);
  Body after = body;
  tumble(after, h);
  const Body right = right_tumble(body, double(h));
  const auto numbers = [&](const Body& now) {
    const quat moved = now.q * conjugate(body.q);
    const double unit = std::min(1.0, angle), one = moved.w < 0 ? -1 : 1;
    return Numbers{one * double(moved.x) / unit, one * double(moved.y) / unit,
                   one * double(moved.z) / unit, double(now.w.x) * u.s, double(now.w.y) * u.s,
                   double(now.w.z) * u.s};
  };
  return {{"x", "y", "z of the axis times sin(angle / 2)", "w.x", "w.y", "w.z"}, numbers(after),
          numbers(right), {50 + 1e-4 / angle}};
}

// ---- many steps ---------------------------------------------------------------------------------

/// How often a brick that spins about its middle axis turns over in some seconds.
template <class Move>
int turnings(Move move, double seconds, double h) {
  Body body = spinning({1, real(0.7), real(0.4)}, {real(0.01), 6, 0});
  int count = 0;
  bool up = true;
  for (int n = 0; n < int(seconds / h + 0.5); ++n) {
    move(body, real(h));
    const real about_middle = to_local(body, body.w).y;
    if (std::abs(about_middle) > 3 && (about_middle > 0) != up) up = !up, ++count;
  }
  return count;
}

/// The greatest change of the energy and of the angular momentum in 20 s, as fractions.
inline std::pair<double, double> greatest_changes(Body body, double h) {
  const vec3 L = angular_momentum(body);
  const double energy = double(dot(body.w, L));
  double most = 0, momentum = 0;
  for (int n = 0; n < int(20 / h + 0.5); ++n) {
    tumble(body, real(h));
    const vec3 now = angular_momentum(body);
    most = std::max(most, std::abs(double(dot(body.w, now)) / energy - 1));
    momentum = std::max(momentum, double(length(now - L) / length(L)));
  }
  return {most, momentum};
}

/// How far the orientation after a second is from that of very small steps [rad].
inline double off_after_a_second(const Body& start, int steps) {
  Body body = start, fine = start;
  for (int n = 0; n < steps; ++n) tumble(body, 1 / real(steps));
  for (int n = 0; n < 20000; ++n) rotate_freely(fine, 1 / real(20000));
  const quat between = body.q * conjugate(fine.q);
  return 2 * double(length(vec3(between.x, between.y, between.z)));
}

}  // namespace joints::testing
