// Exercise 2.4: the rotation of a body in a step, cases and the usual mistakes.
#pragma once

#include "chapters/02_ball/ball.h"
#include "tests/checker/pieces.h"

namespace joints::testing {

struct RotationCase {
  std::string words;
  quat q;
  vec3 w;
  real h;
  int steps = 1;
};

/// The rotation of a body in a step, piece by piece; a mistake changes one of the pieces.
struct RotationStep {
  using V = const vec3&;
  using Q = const quat&;
  RotationCase c;
  bool normal = true;  ///< the product is normalised
  real limit = 0;      ///< no rotation up to this
  Call<real(V w, real h)> size = [](V w, real h) { return h * length(w); };
  Call<quat(Q q)> at_rest = [](Q q) { return q; };
  Call<vec3(Q q, V w)> in_world = [](Q, V w) { return w; };
  Call<real(V w, real h)> angle = [](V w, real h) { return h * length(w); };
  Call<real(real angle)> for_sine = [](real angle) { return angle / 2; };
  Call<real(real angle)> for_cosine = for_sine;
  Call<vec3(V w, real h)> axis = [](V w, real) { return w / length(w); };
  Call<quat(real sine, real cosine, V axis)> written = [](real s, real c, V axis) {
    return quat(c, s * axis);
  };
  Call<quat(Q turn, Q q)> together = [](Q turn, Q q) { return turn * q; };

  quat step(Q q) const {
    if (size(c.w, c.h) <= limit) return at_rest(q);
    const vec3 w = in_world(q, c.w);
    const real a = angle(w, c.h);
    const quat out = together(written(std::sin(for_sine(a)), std::cos(for_cosine(a)), axis(w, c.h)),
                              q);
    return normal ? normalize(out) : out;
  }
};

inline Pieces<RotationStep> rotation_mistakes() {
  using V = const vec3&;
  using Q = const quat&;
  Pieces<RotationStep> out;
  const auto angle = [&](const char* words, auto angle) {
    out.push_back({words, [=](RotationStep& s) { s.angle = angle; }});
  };
  const auto axis = [&](auto axis) {
    out.push_back(
        {"#axis-not-length-1 the axis must be a unit vector, w / |w|",
         [=](RotationStep& s) { s.axis = axis; }});
  };
  const auto together = [&](const char* words, auto how) {
    out.push_back({words, [=](RotationStep& s) { s.together = how; }});
  };
  const auto written = [&](const char* words, auto how) {
    out.push_back({words, [=](RotationStep& s) { s.written = how; }});
  };
  const auto halves = [&](const char* words, real sine, real cosine) {
    out.push_back({words, [=](RotationStep& s) {
                     s.for_sine = [=](real a) { return sine * a; };
                     s.for_cosine = [=](real a) { return cosine * a; };
                   }});
  };
  angle("#h-forgotten h is missing: the angle is h |w|", [](V w, real) { return length(w); });
  angle("the angle is h |w|, with one h", [](V w, real h) { return h * h * length(w); });
  angle("#square-of-w the angle is h |w|, not h w.w", [](V w, real h) { return h * dot(w, w); });
  const char* const degrees = "#radians-of-radians degrees: std::sin, std::cos and angleAxis take "
                              "radians";
  angle(degrees, [](V w, real h) { return glm::radians(h * length(w)); });
  angle(degrees, [](V w, real h) { return glm::degrees(h * length(w)); });
  for (int i = 0; i < 3; ++i)
    angle("the angle is h |w|, from all three numbers of w",
          [=](V w, real h) { return h * std::abs(w[i]); });
  halves("#half-angle-forgotten the half of the angle is forgotten", 1, 1);
  halves("#half-half the angle is halved twice", real(0.25), real(0.25));
  halves("#half-whole-number nothing turns. Is the half 1 / 2, which is 0 in whole numbers?", 0, 0);
  const char* const both = "#half-angle-cosine-only the half of the angle belongs to both, the "
                           "sine and the cosine";
  halves(both, 1, real(0.5));
  halves(both, real(0.5), 1);
  axis([](V w, real) { return w; });
  axis([](V w, real h) { return h * w; });
  axis([](V w, real h) { return w / (h * length(w)); });
  out.push_back({"#sign-turn the sign of the rotation",
                 [](RotationStep& s) { s.axis = [](V w, real) { return -w / length(w); }; }});
  written("#order-four-numbers the order of the four numbers: quat(w, x, y, z), the cosine first",
          [](real s, real c, V axis) { return quat(s * axis.x, s * axis.y, s * axis.z, c); });
  written("#sine-cosine-exchanged sine and cosine are exchanged: the cosine comes first",
          [](real s, real c, V axis) { return quat(s, c * axis); });
  out.push_back({"#euler-angles h w holds no Euler angles: it is an axis times an angle",
                 [](RotationStep& s) {
                   const vec3 w = s.c.w;
                   const real h = s.c.h;
                   s.written = [=](real, real, V) { return quat(h * w); };
                 }});
  together("#from-the-right the rotation is multiplied from the right, or w is turned by q: w is "
           "in world axes, not body axes",
           [](Q turn, Q q) { return q * turn; });
  together("#old-orientation-lost the old orientation is lost: exp(h w) q",
           [](Q turn, Q) { return turn; });
  together("q is inverted: the rotation stands on the left of q itself",
           [](Q turn, Q q) { return turn * conjugate(q); });
  together("q is no vector: the rotation stands on its left alone",
           [](Q turn, Q q) { return turn * q * conjugate(turn); });
  together("#rotation-added the rotation is added to q: it is multiplied",
           [](Q turn, Q q) { return turn + q; });
  out.push_back({"#w-into-body-axes w is in world axes already: it is not turned by q",
                 [](RotationStep& s) { s.in_world = [](Q q, V w) { return conjugate(q) * w; }; }});
  out.push_back({"#back-start-rest a body at rest keeps q: it does not go back to (1, 0, 0, 0)",
                 [](RotationStep& s) { s.at_rest = [](Q) { return quat(1, 0, 0, 0); }; }});
  const auto first_order = [&](const char* words, real factor, bool right) {
    out.push_back({words, [=](RotationStep& s) {
                     const vec3 a = factor * s.c.h * s.c.w;
                     s.together = [=](Q, Q q) {
                       const quat turn(0, a.x, a.y, a.z);
                       return q + (right ? q * turn : turn * q);
                     };
                   }});
  };
  first_order("#first-order q + h/2 (0, w) q is only the first term of the exponential",
              real(0.5), false);
  first_order("#first-order-without-half q + h (0, w) q is only the first term of the "
              "exponential, and without its half", 1,
              false);
  first_order("q + h/2 q (0, w) is only the first term of the exponential, and from the wrong side",
              real(0.5), true);
  const auto small = [&](real limit, bool with_h) {
    out.push_back({"#small-angles-left-out a small angle is left out: many small steps add up, "
                   "and only an angle of 0 is no rotation", [=](RotationStep& s) {
                     s.limit = limit;
                     s.size = [=](V w, real h) { return (with_h ? h : 1) * length(w); };
                   }});
  };
  for (int digits = 1; digits <= 7; ++digits)
    for (const bool with_h : {true, false}) small(std::pow(real(10), real(-digits)), with_h);
  small(real(1e-8), true);
  return out;
}

inline CaseTable<RotationCase> rotation_table() {
  CaseTable<RotationCase> table{{"2.4", "turning a body"},
                            {"q.w", "q.x", "q.y", "q.z"}, {}, {}, {}, {}};
  // q and -q are the same orientation, so that the one beside the right one is shown; whether it
  // is normalised is another test's question
  const auto after = [](const RotationCase& c, const Call<quat(const quat&)>& step) {
    quat q = c.q, right = c.q;
    for (int n = 0; n < c.steps; ++n) {
      q = step(q);
      right = normalize(rotation(c.h * c.w) * right);
    }
    if (dot(q, right) < 0) q = -q;
    return Numbers{double(q.w), double(q.x), double(q.y), double(q.z)};
  };
  const auto rotated = [=](const RotationStep& one) {
    return after(one.c, [&](const quat& q) { return one.step(q); });
  };
  table.whole = true;
  table.tolerance = 10 * rounding;
  table.yours = [=](const RotationCase& c) {
    return after(c, [&](const quat& q) { return turned(q, c.w, c.h); });
  };
  table.right = [=](const RotationCase& c) { return rotated({c}); };
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
  Pieces<RotationStep> pieces = rotation_mistakes();
  for (auto& one : rotation_mistakes())  // the same where the product is not normalised
    if (!one.words.starts_with("a small angle") && !one.words.starts_with("a body at rest"))
      pieces.push_back({one.words, [change = one.does](RotationStep& s) {
                          change(s);
                          s.normal = false;
                        }});
  add_pieces(table, [](const RotationCase& c) { return RotationStep{c}; }, rotated, pieces);
  return table;
}

}  // namespace joints::testing
