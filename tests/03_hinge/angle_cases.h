// The angle of exercise 3.3 as a table of cases.
#pragma once

#include <numbers>

#include "chapters/03_hinge/hinge.h"
#include "tests/checker/cases.h"

namespace joints::testing {

struct AngleCase {
  std::string words;
  quat q1, q2, start;
  vec3 a1_local;
};

/// What the angle is expected to be: the twist does not ask.
inline constexpr real expected_angle = 7;

/// Hinges that were turned by `twist`, swung by up to a radian out of their axis, then turned as a
/// pair; the signs of the quaternions any way round.
inline std::vector<AngleCase> angle_cases(bool swung) {
  std::vector<AngleCase> out;
  Random random(swung ? 34 : 33);
  for (int draw = 0; draw < 16; ++draw) {
    const vec3 a = normalize(random.vector(1)), any = random.vector(1);
    const real twist = draw == 12 ? real(2e-4) : random.uniform(real(-3.05), real(3.05));
    const vec3 across = normalize(cross(a, any)) * random.uniform(real(0.2), 1);
    const quat swing = swung ? rotation(across) : quat(1, 0, 0, 0);
    const quat q1 = random.turn(), start = draw < 4 ? quat(1, 0, 0, 0) : random.turn();
    const quat q2 = q1 * swing * rotation(twist * a) * start;
    out.push_back({swung ? "askew" : "any pose", draw % 2 ? -q1 : q1, draw % 4 < 2 ? q2 : -q2,
                   draw % 8 < 4 ? start : -start, a});
  }
  return out;
}

inline CaseTable<AngleCase> angle_table() {
  using Case = AngleCase;
  CaseTable<Case> table{{"3.3", "the angle of a hinge"}, {"twist [degrees]"}, {}, {}, {}, {}};
  const auto degrees = [](real angle) { return Numbers{double(angle) * 180 / std::numbers::pi}; };
  judge(table, +[](const HingeAngle& angle, const Body& body1, const Body& body2) {
    return angle.twist(body1, body2);
  }, [=](auto twist, const Case& c) {
    return degrees(twist({c.a1_local, c.start, expected_angle}, static_body(vec3(0), c.q1),
                         static_body(vec3(0), c.q2)));
  });
  table.right = [=](const Case& c) {
    const quat turn = inverse(c.start * inverse(inverse(c.q1) * c.q2));
    const real along = turn.x * c.a1_local.x + turn.y * c.a1_local.y + turn.z * c.a1_local.z;
    return degrees(turn.w < 0 ? 2 * std::atan2(-along, -turn.w) : 2 * std::atan2(along, turn.w));
  };
  for (const bool swung : {false, true})
    for (const Case& c : angle_cases(swung)) table.cases.push_back(c);
  table.tolerance = 57.3 * difference_tolerance;  // acos of a number near 1 is that rough
  return table;
}

}  // namespace joints::testing
