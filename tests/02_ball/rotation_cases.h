// Exercise 2.4: the rotation of a body in a step, cases.
#pragma once

#include "chapters/02_ball/ball.h"
#include "tests/checker/cases.h"

namespace joints::testing {

struct RotationCase {
  std::string words;
  quat q;
  vec3 w;
  real h;
  int steps = 1;
};

inline CaseTable<RotationCase> rotation_table() {
  CaseTable<RotationCase> table{{"2.4", "turning a body"}, {"q.w", "q.x", "q.y", "q.z"}};
  // q and -q are the same orientation, so that the one beside the right one is shown; whether it
  // is normalised is another test's question
  judge(table, turned, [](auto turned, const RotationCase& c) {
    quat q = c.q, right = c.q;
    for (int n = 0; n < c.steps; ++n) {
      q = normalize(turned(q, c.w, c.h));
      right = normalize(rotation(c.h * c.w) * right);
    }
    if (dot(q, right) < 0) q = -q;
    return Numbers{double(q.w), double(q.x), double(q.y), double(q.z)};
  });
  table.right = [](const RotationCase& c) {
    quat q = c.q;
    for (int n = 0; n < c.steps; ++n) q = normalize(rotation(c.h * c.w) * q);
    return Numbers{double(q.w), double(q.x), double(q.y), double(q.z)};
  };
  table.whole = true;
  table.tolerance = 10 * rounding;
  const real third = real(3.14159265358979323846) * 2 / 3;
  table.cases = {{"Numbers, in the text", quat(1, 0, 0, 0), vec3(0, 0, third), real(0.75)}};
  Random random(4);
  for (int draw = 0; draw < 5; ++draw) {
    const quat q = random.turn();
    const vec3 w = random.vector(4);
    table.cases.push_back({"a body in any orientation, h = 0.1 s", q, w, real(0.1)});
  }
  const quat q = table.cases[1].q;
  const vec3 w = table.cases[1].w;
  table.cases.push_back({"a body at rest", q, vec3(0), real(0.1)});
  table.cases.push_back({"1000 steps, together 0.01 rad", q, real(1e-5) * normalize(w), 1, 1000});
  table.cases.push_back({"1000 steps, together 1e-6 rad", q, real(6e-8) * normalize(w),
                         1 / real(60), 1000});
  return table;
}

}  // namespace joints::testing
