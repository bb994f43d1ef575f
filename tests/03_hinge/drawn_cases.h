// Exercises 3.1 to 3.5: cases drawn over scales, sides and angles.
#pragma once

#include <numbers>

#include "chapters/03_hinge/hinge.h"
#include "tests/checker/unit_rates.h"
#include "tests/checker/vector_cases.h"

namespace joints::testing {

/// Two axes, apart by up to 57 degrees (beyond 60 there are other rows): C in units of the angle,
/// or the rows.
inline Drawn drawn_axis(Draw& d, bool of_J) {
  const double tilt = d.size("angle between the axes", std::pow(10, -12 * d.pick()), "rad");
  const quat q1 = d.turn(), q2 = d.turn(), frame = d.turn();
  const vec3 b = frame * vec3(1, 0, 0), c = frame * vec3(0, 1, 0), a2 = frame * vec3(0, 0, 1);
  const vec3 about = normalize(d.number() > 0 ? b + real(0.7) * c : b - real(0.4) * c);
  const vec3 a1 = rotation(real(tilt) * about) * a2;
  const Axis axis{conjugate(q1) * a1, conjugate(q2) * b, conjugate(q2) * c};
  const Body body1 = static_body(vec3(0), q1), body2 = static_body(vec3(1), q2);
  if (of_J) {
    const auto row = [&](const vec3& beside) {
      return row_of([&](const Row& V) {
        return dot(cross(V.w1, a1), beside) + dot(a1, cross(V.w2, beside));
      });
    };
    return drawn_rows(axis.jacobian(body1, body2), Jacobian<2>{{row(b), row(c)}}, 1, 1);
  }
  const Vector<2> C = axis.error(body1, body2);
  const double unit = std::abs(std::sin(tilt)) + 1e-13;
  return {{"C[0] / sin(angle)", "C[1] / sin(angle)"},
          {double(C[0]) / unit, double(C[1]) / unit},
          {double(dot(a1, b)) / unit, double(dot(a1, c)) / unit}, {1 + 1e-5 / unit}};
}

inline Drawn drawn_coupling(Draw& d) {
  const Draw::Units u = d.units(12);
  const Pair pair = d.pair(u);
  const auto row = [&](const char* only) {
    const real push = d.chance(only) ? 0 : 1;
    return Row{push * d.vector(), d.vector(u.m), push * d.vector(), d.vector(u.m)};
  };
  const Row a = row("row a only rotates"), b = row("row b only rotates");
  d.side("one of the rows only rotates", (a.v1 == vec3(0)) != (b.v1 == vec3(0)));
  d.side("both rows only rotate", a.v1 == vec3(0) && b.v1 == vec3(0));
  const double right = double(dense_K(Jacobian<2>{{a, b}}, pair.body1, pair.body2)[0][1]);
  return {{"coupling kg"}, {u.kg * double(coupling(a, b, pair.body1, pair.body2))},
          {u.kg * d.size("coupling", right, "1/kg")}, {50}};
}

/// Angles that differ by whole turns are the same: the right one is that nearest to yours.
inline Drawn drawn_twist(Draw& d) {
  constexpr double pi = std::numbers::pi;
  const bool half = d.chance("exactly half a turn");
  const double twist = half ? pi : d.angle();
  d.size("angle beside none", std::remainder(twist, 2 * pi), "rad");
  d.size("angle beside half a turn", std::remainder(twist - pi, 2 * pi), "rad");
  d.side("the angle is negative", std::remainder(twist, 2 * pi) < 0);
  const vec3 a = half ? vec3(0, 0, 1) : normalize(d.vector());
  const quat none(1, 0, 0, 0), q1 = half ? none : d.turn(), start = half ? none : d.turn();
  const quat q2 = half ? quat(0, 0, 0, 1) : q1 * rotation(real(twist) * a) * start;
  const HingeAngle angle{a, start, 0};
  // near 0 an arc cosine is right to a rounding error over the angle
  const double small = std::abs(std::remainder(twist, 2 * pi));
  const double yours = double(angle.twist(static_body(vec3(0), q1), static_body(vec3(1), q2)));
  return {{"angle [rad]", "how far beyond pi"},
          {yours, std::max(0.0, std::abs(yours) - pi)},
          {yours + std::remainder(twist - yours, 2 * pi), 0},
          {small + 3e-6 / (small + 1e-9)}};
}

inline Drawn drawn_unwrapped(Draw& d) {
  const double turns = std::floor(d.size("turns", d.scale(7), ""));
  const double expected = d.any_size(7), apart = 3 * (2 * d.pick() - 1);
  const double away = (d.number() < 0 ? -2 : 2) * std::numbers::pi * turns;
  const double measured = expected + apart + away;
  return {{"angle [rad]"}, {double(unwrapped(real(measured), real(expected)))}, {expected + apart},
          {10 + std::abs(expected) + std::abs(measured)}};
}

inline Drawn drawn_limit(Draw& d) {
  const double unit = d.size("range", d.scale(), "rad"), h = d.size("h", d.scale(4), "s");
  const Range range{real(-unit * std::abs(d.number())), real(unit * std::abs(d.number()))};
  const double end = double(d.chance("near the upper limit") ? range.upper : range.lower);
  const double apart = unit * d.number(), x = end + apart * std::pow(10, -6 * d.pick());
  const double rate = d.size("|rate|", unit / h * d.any_size(), "rad/s");
  const LimitRow yours = limit_row(range, real(x), real(rate), real(h));
  const double below = x - double(range.lower), above = double(range.upper) - x;
  const bool lower = below + h * rate < above - h * rate;
  const double C = lower ? below : above;
  d.size("|C|", C, "rad");
  d.side("the upper limit is the nearer one now", above < below);
  d.side("a limit is passed", std::min(below, above) < 0);
  d.side("it moves away from the limit", rate * (lower ? 1 : -1) > 0);
  d.side("x is positive", x > 0);
  return {{"C / range", "sign", "live"},
          {double(yours.C) / unit, double(yours.sign), double(yours.live)},
          {C / unit, lower ? 1.0 : -1.0, double(C < h * std::abs(rate) + 0.1 * h)}, {1}};
}

inline Drawn drawn_motor(Draw& d) {
  const double speed = d.size("speed", d.scale(), "rad/s"), h = d.size("h", d.scale(4), "s");
  const double K = d.size("K", d.scale(12), "1/(kg m^2)"), unit = speed / K;
  const double lacks = d.size("|rate - speed|", speed * d.any_size(3), "rad/s");
  const double strength = d.chance("the strength is 0") ? 0 : unit / h;
  const Motor motor{real(speed * d.number()), real(strength * std::abs(d.number()))};
  const double bound = d.size("h strength", h * double(motor.strength), "N m s");
  const double before = d.old_sum(bound, speed / K);
  d.side("the old sum is above 0 and what is lacking, too", lacks < 0 && before > 0);
  d.side("the speed is negative", motor.speed < 0);
  real sum = real(before);
  const double change = double(motor_impulse(real(double(motor.speed) + lacks), real(K), motor,
                                             real(h), sum));
  const double right = std::clamp(before - lacks / K, -bound, bound);
  d.size("new sum", right, "N m s");
  const double size = bound > 0 ? std::min(std::abs(lacks) / K, bound) : std::abs(before);
  return {{"change", "new sum"}, {change / size, double(sum) / size},
          {(right - before) / size, right / size},
          {10 + 1e-6 * (bound + speed / K + std::abs(lacks) / K) / size}};
}

}  // namespace joints::testing
