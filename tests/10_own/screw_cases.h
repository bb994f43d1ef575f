// The screw of exercise 10.3: its error as a table of cases, its row as a fixture.
#pragma once

#include <numbers>

#include "tests/10_own/part_cases.h"

namespace joints::testing {

inline Screw drawn_screw(const Pair& pair, const vec3& axis, const vec3& anchor, real lead) {
  const Point at = point_at(pair.body1, pair.body2, anchor);
  const HingeAngle angle = angle_about(pair.body1, pair.body2, axis);
  return {{at.anchor1_local, at.anchor2_local, angle.a1_local}, angle, lead};
}

inline CaseTable<PartCase<Screw>> screw_table() {
  using Case = PartCase<Screw>;
  const auto of = [](auto combine) {
    return [=](const Case& c) {
      const auto& [one, two] = c.pair;
      return double(combine(c.part.slide.error(one, two), c.part.angle.error(one, two),
                            c.part.lead));
    };
  };
  const real turn = 2 * std::numbers::pi_v<real>;
  const char* const radian = "the lead is the travel of a whole turn: divide it by 2 "
                             "pi";
  return error_table<Screw>(
      {"10.3", "the error C of a screw", 1},
      [](unsigned draw, Random& random) {
        Pair pair = drawn_pair(random);
        const vec3 axis = drawn_axis(random);
        Screw screw = drawn_screw(pair, axis, random.vector(1), random.uniform(real(0.2), 1));
        if (draw % 2) screw.lead = -screw.lead;
        const real angle = random.uniform(-12, 12);
        pair.body2.q = normalize(rotation(angle * axis) * pair.body2.q);
        pair.body2.x += random.uniform(-1, 1) * axis;
        screw.angle.expected = angle + random.uniform(-1, 1);
        return Case{"some turns", screw, pair};
      },
      of([=](real s, real theta, real lead) { return s - lead / turn * theta; }),
      {{radian, of([](real s, real theta, real lead) { return s - lead * theta; })},
       {"the lead is multiplied by 2 pi: divide it",
        of([=](real s, real theta, real lead) { return s - lead * turn * theta; })},
       {"the lead is the travel of a whole turn, 2 pi and not pi",
        of([=](real s, real theta, real lead) { return s - 2 * lead / turn * theta; })},
       {"the sign of the angle: a positive lead moves the nut forward in a positive "
        "turn",
        of([=](real s, real theta, real lead) { return s + lead / turn * theta; })},
       {"the sign: C grows with the displacement",
        of([=](real s, real theta, real lead) { return lead / turn * theta - s; })},
       {"C is an angle: it is to be in metres",
        of([=](real s, real theta, real lead) { return s * turn / lead - theta; })},
       {"C is an angle: it is to be in metres",
        of([=](real s, real theta, real lead) { return theta - s * turn / lead; })},
       {"the angle is missing", of([](real s, real, real) { return s; })},
       {"divided by 360: angles are in radians",
        of([](real s, real theta, real lead) { return s - lead / 360 * theta; })}});
}

/// The travel of a radian.
inline real per_radian(real lead) { return lead * std::numbers::inv_pi_v<real> / 2; }

struct ScrewFixture {
  struct Part : Screw {
    real error(const Body& one, const Body& two) const {
      return slide.error(one, two) - per_radian(lead) * angle.error(one, two);
    }
  };
  static constexpr Subject J{"10.3", "the row J of a screw", 2};
  static constexpr std::array rows{"C"};
  static constexpr bool exact_when_broken = true;
  static Part make(const Pair& pair) {
    return {drawn_screw(pair, normalize(vec3(real(0.6), -1, real(0.3))),
                        vec3(real(0.8), real(0.4), real(-0.6)), real(0.9))};
  }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    const vec3 a = to_world(pair.body1, part.slide.a1_local);
    const real angle = random.uniform(real(-0.5), real(0.5));
    turn_about(pair.body2, world_point(pair.body2, part.slide.anchor2_local), rotation(angle * a));
    pair.body2.x += per_radian(part.lead) * angle * a;
  }
  static std::vector<std::pair<std::string, Jacobian<1>>> mistakes(const Part& part,
                                                                   const Pair& pair) {
    const Row s = part.slide.jacobian(pair.body1, pair.body2);
    const Row t = part.angle.jacobian(pair.body1, pair.body2);
    const real p = per_radian(part.lead);
    const auto row = [](const std::string& words, const Row& J) {
      return std::pair(words, to_jacobian(J));
    };
    const auto combined = [&](real factor) {
      Row J = s;
      J.w1 -= factor * t.w1, J.w2 -= factor * t.w2;
      return J;
    };
    return {row("the lead is the travel of a whole turn: divide it by 2 pi",
                combined(part.lead)),
            row("the sign of the angle's row", combined(-p)),
            row("the sign of the whole row",
                Row{-s.v1, -(s.w1 - p * t.w1), -s.v2, -(s.w2 - p * t.w2)}),
            row("the row of the angle is missing", s),
            row("the levers are missing: w1 and w2 of the displacement belong to "
                "the row, too",
                Row{s.v1, -p * t.w1, s.v2, -p * t.w2}),
            row("the row of the angle stands in v1 and v2: a turn has the blocks w1 "
                "and w2",
                Row{s.v1 - p * t.w1, s.w1, s.v2 - p * t.w2, s.w2}),
            row("the angle of body 1 is missing: the screw turns as well",
                Row{s.v1, s.w1, s.v2, s.w2 - p * t.w2}),
            row("the angle of body 2 is missing",
                Row{s.v1, s.w1 - p * t.w1, s.v2, s.w2}),
            row("the row of an angle: C is in metres, and so is its slope",
                Row{s.v1 / p, s.w1 / p - t.w1, s.v2 / p, s.w2 / p - t.w2}),
            row("the lead is missing", combined(1))};
  }
};

}  // namespace joints::testing
