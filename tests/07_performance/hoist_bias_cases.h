// Exercise 7.1, the biases of a hinge, as a table of cases with its usual mistakes.
#pragma once

#include "tests/07_performance/hoist_cases.h"

namespace joints::testing {

inline CaseTable<HingeCase> hinge_bias_table() {
  using Case = HingeCase;
  using A = Vector<5>;
  // what is done with the five errors, of the case
  const auto from = [](auto change) {
    return [=](const Case& c) {
      const A b = change(c, c.hinge.error(c.pair.body1, c.pair.body2));
      return Numbers(b.begin(), b.end());
    };
  };
  const auto times = [=](auto factor) {
    return from([=](const Case& c, A C) {
      for (real& number : C) number *= factor(c);
      return C;
    });
  };
  const auto rate = [](const Case& c) { return c.hinge.beta / c.h; };
  const auto of_entries = [=](auto change) {  // what is done with the five biases
    return from([=](const Case& c, A C) {
      for (real& number : C) number *= rate(c);
      change(c, C);
      return C;
    });
  };
  // biases of the point from other places of the anchors
  const auto gap = [=](auto place) {
    return of_entries([=](const Case& c, A& b) {
      const vec3 u = place(c, true) - place(c, false);
      for (int i = 0; i < 3; ++i) b[i] = rate(c) * u[i];
    });
  };
  const auto tilt = [=](auto of_a1, auto of_b_and_c) {
    return of_entries([=](const Case& c, A& b) {
      const Axis& axis = c.hinge.axis;
      const vec3 a1 = of_a1(c) * axis.a1_local;
      b[3] = rate(c) * dot(a1, of_b_and_c(c) * axis.b_local);
      b[4] = rate(c) * dot(a1, of_b_and_c(c) * axis.c_local);
    });
  };
  const auto q1 = [](const Case& c) { return c.pair.body1.q; };
  const auto q2 = [](const Case& c) { return c.pair.body2.q; };
  const auto not_turned = [](const Case&) { return quat(1, 0, 0, 0); };

  CaseTable<Case> table{{"7.1", "the biases of a hinge"},
                        {"bias[0]", "bias[1]", "bias[2]", "bias[3]", "bias[4]"},
                        {}, {}, {}, hinge_cases()};
  table.yours = [](const Case& c) {
    const HingeNumbers<real> yours = hoisted(c);
    return Numbers(std::begin(yours.bias), std::end(yours.bias));
  };
  table.right = times(rate);
  table.mistakes = {
      {"the biases are not written yet", of_entries([](const Case&, A& b) { b.fill(unwritten); })},
      {"all are zero: beta C / h, with the error as it is now",
       times([](const Case&) { return real(0); })},
      {"h is forgotten: beta C is a way and an angle, a bias is a velocity: beta C / h",
       times([](const Case& c) { return c.hinge.beta; })},
      {"beta is forgotten: this takes back all of the error in one step",
       times([](const Case& c) { return 1 / c.h; })},
      {"the error itself: beta C / h", times([](const Case&) { return real(1); })},
      {"times h where it must be divided by h",
       times([](const Case& c) { return c.hinge.beta * c.h; })},
      {"the sign: a bias has the sign of C",
       times([=](const Case& c) { return -rate(c); })},
      {"divided by beta: it is a share, a factor",
       times([](const Case& c) { return 1 / (c.hinge.beta * c.h); })},
      {"0.2 in the place of beta: take hinge.beta",
       times([](const Case& c) { return real(0.2) / c.h; })},
      {"60 in the place of 1/h: a step need not be 1/60 s",
       times([](const Case& c) { return 60 * c.hinge.beta; })},
      {"the two of the axis are exchanged: first a1.b, then a1.c",
       of_entries([](const Case&, A& b) { std::swap(b[3], b[4]); })},
      {"a1.b stands there twice: the last one is of a1.c",
       of_entries([](const Case&, A& b) { b[4] = b[3]; })},
      {"a1.c stands there twice: the one before the last is of a1.b",
       of_entries([](const Case&, A& b) { b[3] = b[4]; })},
      {"h is forgotten for the axis: beta C / h for all five",
       of_entries([](const Case& c, A& b) { b[3] *= c.h, b[4] *= c.h; })},
      {"beta is forgotten for the axis: beta C / h for all five",
       of_entries([](const Case& c, A& b) { b[3] /= c.hinge.beta, b[4] /= c.hinge.beta; })},
      {"the axis with the sign turned: a bias has the sign of C",
       of_entries([](const Case&, A& b) { b[3] = -b[3], b[4] = -b[4]; })},
      {"the gap with the sign turned: from the point on body 1 to the point on body 2",
       of_entries([](const Case&, A& b) { b[0] = -b[0], b[1] = -b[1], b[2] = -b[2]; })},
      {"the gap from centre to centre: it runs from anchor to anchor, point.error",
       gap([](const Case& c, bool second) { return c.body(second).x; })},
      {"the gap with levers that are not turned into the world: point.error",
       gap([](const Case& c, bool second) { return c.body(second).x + c.anchor(second); })},
      {"the gap of the levers alone: it runs from anchor to anchor, point.error",
       gap([](const Case& c, bool second) { return twin_lever(c, second); })},
      {"the axis error with nothing turned into the world: axis.error",
       tilt(not_turned, not_turned)},
      {"the axis error with a1_local not turned into the world: axis.error", tilt(not_turned, q2)},
      {"the axis error with b_local and c_local not turned into the world: axis.error",
       tilt(q1, not_turned)},
      {"the axis error with the bodies exchanged: a1 rides on body 1, b and c on body 2",
       tilt(q2, q1)}};
  for (const bool turns : {true, false})  // of which rows, and with or without what w does
    for (const auto& [from, to] : {std::pair{0, 5}, {0, 3}, {3, 5}})
      for (const bool scaled : {false, true}) {
        if (!turns && from == 3) continue;  // the axis rows feel nothing else
        table.mistakes.push_back(
            {"the velocities are mixed in: bias holds what does not depend on them, J V comes in "
             "the solve",
             of_entries([=, from = from, to = to](const Case& c, A& b) {
               Jacobian<5> J = hinge_rows(twin_lever(c, false), twin_lever(c, true), twin_rows(c));
               if (!turns)
                 for (Row& row : J.row) row.w1 = row.w2 = vec3(0);
               for (int i = from; i < to; ++i)
                 b[i] += (scaled ? rate(c) : real(1)) *
                         row_velocity(J[i], c.pair.body1, c.pair.body2);
             })});
      }
  for (int present = 1; present < 31; ++present) {  // which of the five are written or not zero
    std::string missing;
    for (int i = 0; i < 5; ++i)
      if (!(present >> i & 1)) missing += (missing.empty() ? "" : ", ") + table.entries[i];
    for (const real nothing : {unwritten, real(0)})
      table.mistakes.push_back(
          {(nothing == 0 ? "zero: " : "not written yet: ") + missing +
               ". All five errors are fed back, three of the point and two of the axis",
           of_entries([=](const Case&, A& b) {
             for (int i = 0; i < 5; ++i)
               if (!(present >> i & 1)) b[i] = nothing;
           })});
  }
  table.tolerance = 10 * rounding;
  return table;
}

}  // namespace joints::testing
