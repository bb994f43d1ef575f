// Exercise 2.4: how a body turns, cases and the usual mistakes.
#pragma once

#include "chapters/02_ball/ball.h"
#include "tests/checker/cases.h"

namespace joints::testing {

struct SpinCase {
  std::string words;
  quat q;
  vec3 w;
  real h;
  int steps = 1;
};
/// The orientation after one step.
using Spin = std::function<quat(const quat&, const vec3&, real)>;

/// exp(phi) with another angle and another axis: (cos a/2, sin a/2 axis), not normalised.
inline quat turn_by(real angle, const vec3& axis) {
  const vec3 v = std::sin(angle / 2) * axis;
  return {std::cos(angle / 2), v.x, v.y, v.z};
}
inline quat from_vector(const vec3& a) { return {0, a.x, a.y, a.z}; }

inline std::vector<std::pair<std::string, Spin>> spin_mistakes() {
  std::vector<std::pair<std::string, Spin>> out;
  // each as it is and normalised; a body at rest keeps q
  const auto add = [&](const char* words, const Spin& spin) {
    const auto at_rest = [](const vec3& w) { return w == vec3(0); };
    out.push_back({words, [=](const quat& q, const vec3& w, real h) {
                     return at_rest(w) ? q : normalize(spin(q, w, h));
                   }});
    out.push_back({words, [=](const quat& q, const vec3& w, real h) {
                     return at_rest(w) ? q : spin(q, w, h);
                   }});
  };
  const auto by = [](std::function<quat(const vec3& w, real size, real h)> turn) {
    return [=](const quat& q, const vec3& w, real h) { return turn(w, length(w), h) * q; };
  };
  using V = const vec3&;
  using Q = const quat&;
  out.push_back({"a body at rest keeps q: it does not go back to (1, 0, 0, 0)",
                 [](Q q, V w, real h) {
                   return w == vec3(0) ? quat(1, 0, 0, 0) : normalize(rotation(h * w) * q);
                 }});
  const char* const small = "a small angle is left out: many small steps add up, and only an angle "
                            "of 0 is no turn";
  const auto above = [&](real limit, bool with_h) {
    out.push_back({small, [=](Q q, V w, real h) {
                     const real size = (with_h ? h : 1) * length(w);
                     return size < limit ? q : normalize(rotation(h * w) * q);
                   }});
  };
  for (int digits = 1; digits <= 7; ++digits)
    for (const bool with_h : {true, false}) above(std::pow(real(10), real(-digits)), with_h);
  above(real(1e-8), true);
  add("nothing turns", [](Q q, V, real) { return q; });
  add("h is missing: the angle is h |w|", by([](V w, real size, real) {
        return turn_by(size, w / size);
      }));
  add("the half of the angle is forgotten", by([](V w, real size, real h) {
        return turn_by(2 * h * size, w / size);
      }));
  add("h and the half of the angle are forgotten", by([](V w, real size, real) {
        return turn_by(2 * size, w / size);
      }));
  const char* const both = "the half of the angle belongs to both, the sine and the cosine";
  add(both, by([](V w, real size, real h) {
        return quat(std::cos(h * size / 2), std::sin(h * size) / size * w);
      }));
  add(both, by([](V w, real size, real h) {
        return quat(std::cos(h * size), std::sin(h * size / 2) / size * w);
      }));
  add("the angle is halved twice", by([](V w, real size, real h) {
        return turn_by(h * size / 2, w / size);
      }));
  add("the angle is h |w|, with one h", by([](V w, real size, real h) {
        return turn_by(h * h * size, w / size);
      }));
  add("the angle is h |w|, not h w.w", by([](V w, real size, real h) {
        return turn_by(h * size * size, w / size);
      }));
  add("the sign of the turn", by([](V w, real, real h) { return rotation(-h * w); }));
  add("the turn is multiplied from the right, or w is turned by q: w is in world axes, not body "
      "axes",
      [](Q q, V w, real h) { return q * rotation(h * w); });
  add("w is in world axes already: it is not turned by q",
      [](Q q, V w, real h) { return rotation(h * (conjugate(q) * w)) * q; });
  add("the old orientation is lost: exp(h w) q",
      [](Q, V w, real h) { return rotation(h * w); });
  add("q is inverted: the turn stands on the left of q itself",
      [](Q q, V w, real h) { return rotation(h * w) * conjugate(q); });
  add("q is no vector: the turn stands on its left alone",
      [](Q q, V w, real h) { return rotation(h * w) * q * conjugate(rotation(h * w)); });
  add("the turn is added to q: it is multiplied", [](Q q, V w, real h) {
    return rotation(h * w) + q;
  });
  const char* const order = "the order of the four numbers: quat(w, x, y, z), the cosine first";
  add(order, by([](V w, real, real h) {
        const quat turn = rotation(h * w);
        return quat(turn.x, turn.y, turn.z, turn.w);
      }));
  add("sine and cosine are exchanged: the cosine comes first", by([](V w, real size, real h) {
        return quat(std::sin(h * size / 2), std::cos(h * size / 2) / size * w);
      }));
  add("degrees: std::sin and std::cos take radians", by([](V w, real size, real h) {
        return turn_by(glm::radians(h * size), w / size);
      }));
  add("degrees: std::sin, std::cos and angleAxis take radians", by([](V w, real size, real h) {
        return turn_by(glm::degrees(h * size), w / size);
      }));
  const char* const unit_axis = "the axis must be a unit vector, w / |w|";
  add(unit_axis, by([](V w, real size, real h) { return turn_by(h * size, w); }));
  add(unit_axis, by([](V w, real size, real h) { return turn_by(h * size, h * w); }));
  add(unit_axis, by([](V w, real size, real h) { return turn_by(h * size, w / (h * size)); }));
  const char* const first = "q + h/2 (0, w) q is only the first term of the exponential";
  add(first, [](Q q, V w, real h) { return q + from_vector(h / 2 * w) * q; });
  add("q + h (0, w) q is only the first term of the exponential, and without its half",
      [](Q q, V w, real h) { return q + from_vector(h * w) * q; });
  add("q + h/2 q (0, w) is only the first term of the exponential, and from the wrong side",
      [](Q q, V w, real h) { return q + q * from_vector(h / 2 * w); });
  add("h w holds no Euler angles: it is an axis times an angle", by([](V w, real, real h) {
        return quat(h * w);
      }));
  return out;
}

inline CaseTable<SpinCase> spin_table() {
  CaseTable<SpinCase> table{{"2.4", "turning a body"},
                             {"q.w", "q.x", "q.y", "q.z"}, {}, {}, {}, {}};
  // q and -q are the same orientation: the one beside the right one is shown
  const auto after = [](const SpinCase& c, const Spin& spin) {
    quat q = c.q, right = c.q;
    for (int n = 0; n < c.steps; ++n) {
      q = spin(q, c.w, c.h);
      right = normalize(rotation(c.h * c.w) * right);
    }
    if (dot(q, right) < 0) q = -q;
    return Numbers{double(q.w), double(q.x), double(q.y), double(q.z)};
  };
  table.whole = true;
  table.tolerance = 10 * rounding;
  table.yours = [=](const SpinCase& c) { return after(c, turned); };
  table.right = [=](const SpinCase& c) {
    return after(c, [](const quat& q, const vec3& w, real h) {
      return w == vec3(0) ? q : normalize(rotation(h * w) * q);
    });
  };
  for (const auto& [words, spin] : spin_mistakes())
    table.mistakes.push_back(
        {words, [=, spin = spin](const SpinCase& c) { return after(c, spin); }});
  const real third = real(3.14159265358979323846) * 2 / 3;
  table.cases = {{"Numbers, in the text", quat(1, 0, 0, 0), vec3(0, 0, third), real(0.75)}};
  Random random(4);
  for (int draw = 0; draw < 5; ++draw) {
    const quat q = random.turn();
    const vec3 w = random.vector(4);
    table.cases.push_back({"a body that lies anyhow, h = 0.1 s", q, w, real(0.1)});
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
