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

/// The travel of a radian.
inline real per_radian(real lead) { return lead * std::numbers::inv_pi_v<real> / 2; }

inline CaseTable<PartCase<Screw>> screw_table() {
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
        return PartCase<Screw>{"some turns", screw, pair};
      },
      [](const Screw& screw, const Pair& pair) {
        const auto& [one, two] = pair;
        return screw.slide.error(one, two) - per_radian(screw.lead) * screw.angle.error(one, two);
      });
}

struct ScrewFixture {
  struct Part : Screw {
    real error(const Body& one, const Body& two) const {
      return slide.error(one, two) - per_radian(lead) * angle.error(one, two);
    }
  };
  using Exercise = Screw;
  static constexpr Subject J{"10.3", "the row J of a screw", 2};
  static constexpr std::array rows{"C"};
  static constexpr bool exact_when_broken = true;
  static Part make(const Pair& pair) {
    const real lead = real(pair.body2.q.x > 0 ? 0.9 : -0.9);  // half of the screws are left-handed
    return {drawn_screw(pair, normalize(vec3(real(0.6), -1, real(0.3))),
                        vec3(real(0.8), real(0.4), real(-0.6)), lead)};
  }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    const vec3 a = to_world(pair.body1, part.slide.a1_local);
    const real angle = random.uniform(real(-0.5), real(0.5));
    turn_about(pair.body2, world_point(pair.body2, part.slide.anchor2_local), rotation(angle * a));
    pair.body2.x += per_radian(part.lead) * angle * a;
  }
};

}  // namespace joints::testing
