// Exercise 7.1, the biases of a hinge, as a table of cases with its usual mistakes.
#pragma once

#include "tests/07_performance/hoist_cases.h"
#include "tests/checker/pieces.h"

namespace joints::testing {

/// The five errors, their factors, and the operations on the numbers.
struct BiasReference {
  HingeCase c;
  Vector<5> C, rate, more{};
  Call<void(Vector<5>&)> after;

  explicit BiasReference(const HingeCase& c) : c(c), C(c.hinge.error(c.pair.body1, c.pair.body2)) {
    rate.fill(c.hinge.beta / c.h);
  }
  Numbers biases() const {
    Vector<5> b;
    for (std::size_t i = 0; i < 5; ++i) b[i] = rate[i] * C[i] + more[i];
    if (after) after(b);
    return Numbers(b.begin(), b.end());
  }
};

/// What may be wrong with the rate or the number of each: all five, those of the point, those of
/// the axis.
inline Pieces<BiasReference> wrong_rates() {
  using T = BiasReference;
  struct Rule {
    const char* words;
    real (*of)(const HingeCase&);
  };
  const Rule rates[] = {
      {"h is forgotten: beta C is a length or an angle, a bias is a velocity: beta C / h",
       [](const HingeCase& c) { return c.hinge.beta; }},
      {"#without-beta beta is forgotten: this removes all of the error in one step",
       [](const HingeCase& c) { return 1 / c.h; }},
      {"the error itself: beta C / h", [](const HingeCase&) { return real(1); }},
      {"times h where it must be divided by h",
       [](const HingeCase& c) { return c.hinge.beta * c.h; }},
      {"divided by h twice", [](const HingeCase& c) { return c.hinge.beta / (c.h * c.h); }},
      {"the sign: a bias has the sign of C",
       [](const HingeCase& c) { return -c.hinge.beta / c.h; }},
      {"divided by beta: it is a fraction, a factor",
       [](const HingeCase& c) { return 1 / (c.hinge.beta * c.h); }},
      {"h and beta are exchanged: beta / h", [](const HingeCase& c) { return c.h / c.hinge.beta; }},
      {"1 - beta in the place of beta",
       [](const HingeCase& c) { return (1 - c.hinge.beta) / c.h; }},
      {"0.2 in the place of beta: take hinge.beta",
       [](const HingeCase& c) { return real(0.2) / c.h; }},
      {"#for-sixty-steps 60 in the place of 1/h: a step may have another length than 1/60 s",
       [](const HingeCase& c) { return 60 * c.hinge.beta; }},
      {"#rate-int beta / h is cut to a whole number: an int has no fraction",
       [](const HingeCase& c) { return std::trunc(c.hinge.beta / c.h); }}};
  Pieces<T> out;
  struct Group {
    const char* words;
    std::size_t from, to;
  };
  for (const Group& group : {Group{"", 0, 5}, {" (the point)", 0, 3}, {" (the axis)", 3, 5}}) {
    const auto each = [&](const std::string& words, auto change) {
      out.push_back({words + group.words, [=](T& t) {
                       for (std::size_t i = group.from; i < group.to; ++i) change(t, i);
                     }});
    };
    for (const Rule& rule : rates)
      each(rule.words, [=](T& t, std::size_t i) { t.rate[i] = rule.of(t.c); });
    each("#added-what-stood-there added to the old value: = and not +=",
         [](T& t, std::size_t i) { t.more[i] = real(unwritten); });
    each("the size of the error: a bias has its sign",
         [](T& t, std::size_t i) { t.C[i] = std::abs(t.C[i]); });
    each("only negative errors are fed back",
         [](T& t, std::size_t i) { t.C[i] = std::min(t.C[i], real(0)); });
    each("only positive errors are fed back",
         [](T& t, std::size_t i) { t.C[i] = std::max(t.C[i], real(0)); });
  }
  return out;
}

/// What may be taken for the errors.
inline Pieces<BiasReference> wrong_errors() {
  using T = BiasReference;
  // another gap
  const auto gap = [](auto of) {
    return Call<void(T&)>([=](T& t) {
      const vec3 u = of(t.c);
      for (int i = 0; i < 3; ++i) t.C[std::size_t(i)] = u[i];
    });
  };
  // a gap between other places
  const auto between = [=](auto place) {
    return gap([=](const HingeCase& c) { return place(c, true) - place(c, false); });
  };
  const auto tilt = [](auto of_a1, auto of_b_and_c) {
    return Call<void(T&)>([=](T& t) {
      const Axis& axis = t.c.hinge.axis;
      const vec3 a1 = of_a1(t.c) * axis.a1_local;
      t.C[3] = dot(a1, of_b_and_c(t.c) * axis.b_local);
      t.C[4] = dot(a1, of_b_and_c(t.c) * axis.c_local);
    });
  };
  const auto q1 = [](const HingeCase& c) { return c.pair.body1.q; };
  const auto q2 = [](const HingeCase& c) { return c.pair.body2.q; };
  const auto not_turned = [](const HingeCase&) { return quat(1, 0, 0, 0); };
  const auto right_gap = [](const HingeCase& c) {
    const Vector<5> C = c.hinge.error(c.pair.body1, c.pair.body2);
    return vec3(C[0], C[1], C[2]);
  };
  return {
      {"#axis-biases-exchanged the two of the axis are exchanged: first a1.b, then a1.c",
       [](T& t) { std::swap(t.C[3], t.C[4]); }},
      {"a1.b stands there twice: the last one is of a1.c", [](T& t) { t.C[4] = t.C[3]; }},
      {"a1.c stands there twice: the one before the last is of a1.b",
       [](T& t) { t.C[3] = t.C[4]; }},
      {"the gap stands there once more in the place of the axis error: axis.error",
       [](T& t) { t.C[3] = t.C[0], t.C[4] = t.C[1]; }},
      {"#one-place-too-early the two of the axis begin one place too early: bias[3] and bias[4]",
       [](T& t) {
         t.after = [](Vector<5>& b) { b = {b[0], b[1], b[3], b[4], real(unwritten)}; };
       }},
      {"the bodies are exchanged: point.error(body1, body2)",
       gap([](const HingeCase& c) { return c.hinge.point.error(c.pair.body2, c.pair.body1); })},
      {"#of-exchanged-bodies the bodies are exchanged: axis.error(body1, body2)",
       [](T& t) {
         const Vector<2> C = t.c.hinge.axis.error(t.c.pair.body2, t.c.pair.body1);
         t.C[3] = C[0], t.C[4] = C[1];
       }},
      {"the gap from centre to centre: it runs from anchor to anchor, point.error",
       between([](const HingeCase& c, bool second) { return c.body(second).x; })},
      {"the gap with levers that are not turned into the world: point.error",
       between([](const HingeCase& c, bool second) {
         return c.body(second).x + c.anchor(second);
       })},
      {"the gap of the levers alone: it runs from anchor to anchor, point.error",
       between([](const HingeCase& c, bool second) { return reference_lever(c, second); })},
      {"#in-body-axes the gap in the axes of body 1: point.error is in world axes already",
       gap([=](const HingeCase& c) { return to_local(c.pair.body1, right_gap(c)); })},
      {"the gap in the axes of body 2: point.error is in world axes already",
       gap([=](const HingeCase& c) { return to_local(c.pair.body2, right_gap(c)); })},
      {"the length of the gap in all three: it has three numbers",
       gap([=](const HingeCase& c) { return vec3(length(right_gap(c))); })},
      {"the axis error with nothing turned into the world: axis.error",
       tilt(not_turned, not_turned)},
      {"the axis error with a1_local not turned into the world: axis.error", tilt(not_turned, q2)},
      {"the axis error with b_local and c_local not turned into the world: axis.error",
       tilt(q1, not_turned)},
      {"the axis error with the bodies exchanged: a1 rides on body 1, b and c on body 2",
       tilt(q2, q1)}};
}

/// The velocities among the errors, in some rows, with or without what w does.
inline Pieces<BiasReference> wrong_velocities() {
  using T = BiasReference;
  Pieces<T> out;
  for (const bool turns : {true, false})
    for (const auto& [from, to] : {std::pair{0, 5}, {0, 3}, {3, 5}})
      for (const bool scaled : {false, true}) {
        if (!turns && from == 3) continue;  // the axis rows feel nothing else
        out.push_back({"#with-velocities the velocities are included: the bias does not depend on "
                       "them, J V is computed in the solve", [=, from = from, to = to](T& t) {
                         const HingeCase& c = t.c;
                         Jacobian<5> J = hinge_rows(reference_lever(c, false),
                                                    reference_lever(c, true), reference_rows(c));
                         if (!turns)
                           for (Row& row : J.row) row.w1 = row.w2 = vec3(0);
                         for (int i = from; i < to; ++i)
                           t.more[std::size_t(i)] +=
                               (scaled ? c.hinge.beta / c.h : real(1)) *
                               row_velocity(J[i], c.pair.body1, c.pair.body2);
                       }});
      }
  return out;
}

inline CaseTable<HingeCase> hinge_bias_table() {
  using Case = HingeCase;
  CaseTable<Case> table{{"7.1", "the biases of a hinge"},
                        {"bias[0]", "bias[1]", "bias[2]", "bias[3]", "bias[4]"},
                        {}, {}, {}, hinge_cases()};
  table.yours = [](const Case& c) {
    const HingeNumbers<real> yours = hoisted(c);
    return Numbers(yours.bias.begin(), yours.bias.end());
  };
  table.right = [](const Case& c) { return BiasReference(c).biases(); };
  table.tolerance = 10 * rounding;
  Pieces<BiasReference> pieces = {{"the biases are not written yet",
                                   [](BiasReference& t) {
                                     t.C = {}, t.more.fill(real(unwritten));
                                   }},
                                  {"all are zero: beta C / h, with the error as it is now",
                                   [](BiasReference& t) { t.C = {}; }}};
  for (int present = 1; present < 31; ++present) {  // which of the five are written or not zero
    std::string missing;
    for (int i = 0; i < 5; ++i)
      if (!(present >> i & 1)) missing += (missing.empty() ? "" : ", ") + table.entries[i];
    for (const real nothing : {real(unwritten), real(0)})
      pieces.push_back({(nothing == 0 ? "zero: " : "not written yet: ") + missing +
                            ". All five errors are fed back, three of the point and two of the "
                            "axis",
                        [=](BiasReference& t) {
                          for (std::size_t i = 0; i < 5; ++i)
                            if (!(present >> i & 1)) t.C[i] = 0, t.more[i] = nothing;
                        }});
  }
  for (const Pieces<BiasReference>& more : {wrong_rates(), wrong_errors(), wrong_velocities()})
    pieces.insert(pieces.end(), more.begin(), more.end());
  add_pieces(table, [](const Case& c) { return BiasReference(c); },
             [](const BiasReference& t) { return t.biases(); }, pieces);
  return table;
}

}  // namespace joints::testing
