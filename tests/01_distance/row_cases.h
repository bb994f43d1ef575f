// Exercise 1.3: the impulse of one row, and its effect. Cases.
#pragma once

#include "chapters/01_distance/distance.h"
#include "tests/checker/impulse_cases.h"
#include "tests/checker/push_cases.h"

namespace joints::testing {

// The pose for pencil and paper in the chapter's text.
inline const Body rod_paper1 = body_with(2, vec3(1), vec3(0));
inline const Body rod_paper2 = [] {
  Body body = body_with(3, vec3(1), vec3(real(1.2), real(1.6), 0));
  body.v = vec3(1, real(0.5), 0);
  return body;
}();
inline const Row rod_paper_J{vec3(real(-0.6), real(-0.8), 0), vec3(0),
                         vec3(real(0.6), real(0.8), 0), vec3(0)};

// A row of no rod: none of its blocks is another one with its sign turned.
inline const Row turning_J{vec3(real(-0.6), real(-0.8), real(0.1)),
                           vec3(real(0.2), real(-0.5), real(0.9)),
                           vec3(real(0.5), real(0.4), real(-0.7)),
                           vec3(real(0.7), real(0.1), real(-0.3))};

inline Pair moving_pair() {
  Pair pair = uneven_pair();
  Random random(5);
  move_together(pair, random);
  for (Body* body : {&pair.body1, &pair.body2}) {
    body->v = random.vector(2);
    body->w = random.vector(2);
  }
  return pair;
}

inline real turning_K(const Pair& pair) {
  return dense_K(to_jacobian(turning_J), pair.body1, pair.body2)[0][0];
}
inline CaseTable<LackCase> row_impulse_table() {
  const Pair paper{rod_paper1, rod_paper2}, moving = moving_pair();
  const Pair walls{static_body(vec3(0)), static_body(vec3(1, 0, 0))};
  const Pair hung{static_body(vec3(0)), rod_paper2};
  Pair resting = paper, slow = paper;
  resting.body2.v = vec3(0);
  slow.body2.v = real(1e-9) * rod_paper2.v;
  const real K = turning_K(moving);
  CaseTable<LackCase> table = lack_table(
      {"1.3", "the impulse of a row"}, {"lambda"},
      row_impulse, [](auto impulse, const LackCase& c) {
        return Numbers{
            double(impulse(c.J[0], c.K[0], real(c.b[0]), c.pair.body1, c.pair.body2))};
      });
  table.cases = {
      {"Numbers, in the text", {rod_paper_J}, {real(5) / 6}, {6}, paper},
      {"bias 0", {rod_paper_J}, {real(5) / 6}, {0}, paper},
      {"a rod that is too short, bias -9 m/s", {rod_paper_J}, {real(5) / 6}, {-9}, paper},
      {"bodies at rest, bias 6 m/s", {rod_paper_J}, {real(5) / 6}, {6}, resting},
      {"beside a wall", {rod_paper_J}, {real(1) / 3}, {6}, hung},
      {"a row that also turns, moving bodies", {turning_J}, {K}, {0.7}, moving},
      {"J V + b of 3e-9 m/s, lambda in 1e-9 N s", {rod_paper_J}, {real(5) / 6}, {2e-9}, slow,
       1e-9},
      {"heavy bodies, K = 1e-9 / kg, lambda in 1e9 N s", {rod_paper_J}, {real(1e-9)}, {6}, paper,
       1e9},
      {"heavier bodies, K = 1e-20 / kg, lambda in 1e20 N s", {rod_paper_J}, {real(1e-20)}, {6},
       paper, 1e20},
      {"two walls, K = 0", {rod_paper_J}, {0}, {6}, walls},
  };
  return table;
}

inline CaseTable<PushCase> row_push_table() {
  const Pair moving = moving_pair();
  Pair hung = moving, light = moving;
  hung.body1 = static_body(moving.body1.x, moving.body1.q);
  for (Body* body : {&light.body1, &light.body2}) {
    body->inverse_mass *= real(1e9);
    body->inverse_inertia_local *= real(1e9);
  }
  return push_table(
      {"1.3", "applying the impulse of a row", 2},
      apply_impulse, [](auto apply, const PushCase& c, Pair& pair) {
        apply(c.J[0], c.lambda[0], pair.body1, pair.body2);
      },
      {{"moving bodies, lambda = 0.8 N s", {turning_J}, {real(0.8)}, moving},
       {"moving bodies, lambda = -1.3 N s", {turning_J}, {real(-1.3)}, moving},
       {"body 1 is static", {turning_J}, {real(0.8)}, hung},
       {"bodies of a microgram, lambda = 1e-9 N s", {turning_J}, {real(1e-9)}, light}});
}

}  // namespace joints::testing
