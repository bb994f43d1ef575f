// The angle of exercise 3.3 as a table of cases with its usual mistakes.
#pragma once

#include <algorithm>
#include <numbers>

#include "chapters/03_hinge/hinge.h"
#include "tests/checker/cases.h"

namespace joints::testing {

inline const char* const told_difference_of_angles =
    "#difference-of-angles a difference of two angles: the turns are multiplied, q1^-1 q2 "
    "start^-1";
inline const char* const told_minus_expected =
    "#minus-expected `expected` does not belong here: return the measured twist, in (-pi, pi]";

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
  constexpr real pi = std::numbers::pi_v<real>;
  const auto vector = [](const quat& q) { return vec3(q.x, q.y, q.z); };
  const auto up = [](const quat& q) { return q.w < 0 ? -q : q; };
  const auto degrees = [](real angle) { return Numbers{double(angle) * 180 / std::numbers::pi}; };
  // the right turn, and the right angle of a turn
  const auto turn = [](const Case& c) { return conjugate(c.q1) * c.q2 * conjugate(c.start); };
  const auto angle_of = [=](const quat& q, const vec3& a) {
    return 2 * std::atan2(dot(vector(up(q)), a), up(q).w);
  };
  // another turn, another axis, another angle of the right rotation
  const auto of = [=](auto other) {
    return [=](const Case& c) { return degrees(angle_of(other(c), c.a1_local)); };
  };
  const auto about = [=](auto axis) {
    return [=](const Case& c) { return degrees(angle_of(turn(c), axis(c))); };
  };
  const auto angle = [=](auto other) {
    return [=](const Case& c) {
      const quat q = up(turn(c));
      return degrees(other(dot(vector(q), c.a1_local), q.w, length(vector(q))));
    };
  };
  const auto as_it_comes = [=](auto other) {
    return [=](const Case& c) {
      const quat q = turn(c);
      return degrees(other(dot(vector(q), c.a1_local), q.w, length(vector(q))));
    };
  };
  const auto total = [](real, real s, real v) { return 2 * std::atan2(v, s); };
  const auto as_it_stands = [=](const quat& q, const vec3& a) {
    return 2 * std::atan2(dot(vector(q), a), q.w);
  };
  const auto signed_total = [](real p, real s, real v) {
    return 2 * std::atan2(p < 0 ? -v : v, s);
  };
  const auto twist = [](real p, real s, real) { return 2 * std::atan2(p, s); };
  const char* const no_sign = "#no-sign-rule no sign rule: q and -q are the same rotation. Where "
                              "s < 0 take -q";
  const char* const all_of_it = "#glm-angle the angle of the whole rotation: that has the swing "
                                "in it, and no sign. The twist takes only p, the part of v along "
                                "the axis";
  const char* const world_frame =
      "#turn-world the rotation in world axes (q2 q1^-1): it changes when both bodies rotate "
      "together. q1^-1 q2 is body 2 in the axes of body 1";
  const char* const start_inverse = "start is multiplied, not its inverse";
  const char* const axis_frame = "#axis-turn-different-frames the axis and the turn in different "
                                 "frames: in body 1's frame the axis is a1_local as it stands";

  CaseTable<Case> table{{"3.3", "the angle of a hinge"}, {"twist [degrees]"}, {}, {}, {}, {}};
  table.yours = [=](const Case& c) {
    Body body1, body2;
    body1.q = c.q1;
    body2.q = c.q2;
    return degrees(HingeAngle{c.a1_local, c.start, expected_angle}.twist(body1, body2));
  };
  table.right = of(turn);
  table.mistakes = {
      {no_sign, as_it_comes(twist)},
      {"#sign-s-alone s alone changes its sign: where s < 0 negate all of q, p too",
       as_it_comes([](real p, real s, real) { return 2 * std::atan2(p, std::abs(s)); })},
      {"#sign-rule-conjugate v alone changes its sign: where s < 0 negate all of q, s too",
       as_it_comes([](real p, real s, real) { return 2 * std::atan2(s < 0 ? -p : p, s); })},
      {"#world-frame-no-sign the rotation in world axes (take q1^-1 q2), and no sign rule (s < 0: "
       "take -q)",
       [=](const Case& c) {
         return degrees(as_it_stands(c.q2 * conjugate(c.q1) * conjugate(c.start), c.a1_local));
       }},
      {all_of_it, as_it_comes(total)},
      {all_of_it, angle(total)},
      {all_of_it, angle(signed_total)},
      {all_of_it, as_it_comes(signed_total)},
      {all_of_it, [=](const Case& c) { return degrees(glm::angle(turn(c))); }},
      {all_of_it, [=](const Case& c) { return degrees(glm::angle(up(turn(c)))); }},
      {world_frame,
       of([](const Case& c) { return c.q2 * conjugate(c.q1) * conjugate(c.start); })},
      {world_frame,
       [=](const Case& c) {
         return degrees(angle_of(c.q2 * conjugate(c.q1) * conjugate(c.start),
                                 c.q1 * c.a1_local));
       }},
      {"#total-angle-world the rotation in world axes, and its whole angle: take q1^-1 q2, and "
       "only p",
       [=](const Case& c) {
         const quat q = c.q2 * conjugate(c.q1) * conjugate(c.start);
         return degrees(total(0, q.w, length(vector(q))));
       }},
      {"#factor-two-forgotten the factor 2 is missing: a quaternion holds half the angle",
       angle([](real p, real s, real) { return std::atan2(p, s); })},
      {"a factor of 4: the quaternion holds half the angle, so take it twice",
       angle([](real p, real s, real) { return 4 * std::atan2(p, s); })},
      {"#atan2-exchanged the arguments of atan2 are exchanged: first p, then s",
       angle([](real p, real s, real) { return 2 * std::atan2(s, p); })},
      {"the sign of the rotation: it is that of body 2 in the axes of body 1",
       angle([](real p, real s, real) { return -2 * std::atan2(p, s); })},
      {"the sign is lost",
       angle([](real p, real s, real) { return 2 * std::atan2(std::abs(p), s); })},
      {"half the range: the sine of 80 degrees is that of 100. atan2 takes p and s",
       angle([](real p, real s, real) { return std::asin(std::sin(2 * std::atan2(p, s))); })},
      {"#wrapped-0-2pi from 0 to 360 degrees: the angle must be in (-pi, pi]",
       angle([](real p, real s, real) {
         const real half = std::atan2(p, s);
         return 2 * (half < 0 ? half + pi : half);
       })},
      {"#asin-of-p the sine alone: p is the sine of half the twist only where nothing swings",
       angle([](real p, real, real) { return 2 * std::asin(p); })},
      {"2 p is the angle only while it is small", angle([](real p, real, real) { return 2 * p; })},
      {"#degrees degrees where radians belong",
       angle([=](real p, real s, real) { return 360 / pi * std::atan2(p, s); })},
      {told_minus_expected,
       angle([](real p, real s, real) { return 2 * std::atan2(p, s) - expected_angle; })},
      {told_minus_expected,
       angle([](real p, real s, real) {
         const real twist = 2 * std::atan2(p, s);
         return expected_angle + std::remainder(twist - expected_angle, 2 * pi);
       })},
      {"#sign-rule-w-0 the sign rule the wrong way round: where s > 0 -q was taken",
       angle([](real p, real s, real) { return 2 * std::atan2(-p, -s); })},
      {"#sign-rule-p p decides which of q and -q is taken: the sign of s does",
       as_it_comes([](real p, real s, real) { return 2 * std::atan2(p, p < 0 ? -s : s); })},
      {"#sign-rule-x x decides which of q and -q is taken: the sign of s does",
       [=](const Case& c) {
         const quat q = turn(c);
         return degrees(as_it_stands(q.x < 0 ? -q : q, c.a1_local));
       }},
      {"#atan2-double-angle the factor 2 belongs in front of atan2, not in front of p",
       angle([](real p, real s, real) { return std::atan2(2 * p, s); })},
      {"p and s are multiplied: std::atan2 takes both, their quotient is the tangent",
       as_it_comes([](real p, real s, real) { return 2 * std::atan(p * s); })},
      {"#glm-angle-sign the part of the vector along the axis: that is the twist only where "
       "nothing swings",
       angle([](real p, real s, real v) { return v > 0 ? 2 * std::atan2(v, s) * p / v : 0; })},
      {"#vector-q-w-q the numbers w, x, y: the vector of q is (q.x, q.y, q.z)",
       [=](const Case& c) {
         const quat q = up(turn(c));
         return degrees(2 * std::atan2(dot(vec3(q.w, q.x, q.y), c.a1_local), q.w));
       }},
      {"#int-angle the angle is cut off to a whole number: an int has no fraction",
       angle([](real p, real s, real) { return std::trunc(2 * std::atan2(p, s)); })},
      {"#difference a difference of quaternions is no rotation: q1^-1 q2", [=](const Case& c) {
         return degrees(as_it_stands(c.q2 - c.q1, c.a1_local));
       }},
      {"angles about three axes are no rotation: their sum along the axis is not the twist",
       [=](const Case& c) { return degrees(dot(glm::eulerAngles(turn(c)), c.a1_local)); }},
      {"angles about three axes are no rotation: their sum along the axis is not the twist",
       [=](const Case& c) { return degrees(dot(glm::eulerAngles(up(turn(c))), c.a1_local)); }},
      {"#only-body-2 body 2 alone: the angle is that of body 2 in the axes of body 1, q1^-1 q2",
       of([](const Case& c) { return c.q2; })},
      {told_difference_of_angles,
       [=](const Case& c) {
         return degrees(angle_of(conjugate(c.q1) * c.q2, c.a1_local) -
                        angle_of(c.start, c.a1_local));
       }},
      {told_difference_of_angles,
       [=](const Case& c) {
         return degrees(as_it_stands(c.q2, c.a1_local) - as_it_stands(c.q1, c.a1_local));
       }},
      {"half the range: the sine of 80 degrees is that of 100. atan2 takes p and s",
       angle([](real p, real s, real) { return std::asin(2 * p * s); })},
      {"#v-made-unit-vector v is not made a unit vector: its length is the sine",
       angle([](real p, real s, real v) { return 2 * std::atan2(p / v, s); })},
      {"#atan-ratio-reversed the quotient the wrong way round: the tangent is p / s",
       as_it_comes([](real p, real s, real) { return 2 * std::atan(s / p); })},
      {"start is forgotten, and the sign rule (where s < 0 negate all of q)",
       [=](const Case& c) {
         return degrees(as_it_stands(conjugate(c.q1) * c.q2, c.a1_local));
       }},
      {"#start-forgotten start is forgotten",
       of([](const Case& c) { return conjugate(c.q1) * c.q2; })},
      {start_inverse, of([](const Case& c) { return conjugate(c.q1) * c.q2 * c.start; })},
      {"#start-wrong-side start^-1 stands on the wrong side: q1^-1 q2 start^-1",
       of([](const Case& c) { return conjugate(c.start) * conjugate(c.q1) * c.q2; })},
      {"start stands on the wrong side, and not its inverse: q1^-1 q2 start^-1",
       of([](const Case& c) { return c.start * conjugate(c.q1) * c.q2; })},
      {"body 1's rotation is forgotten: q1^-1 q2 start^-1",
       of([](const Case& c) { return c.q2 * conjugate(c.start); })},
      {"q1 is multiplied, not its inverse",
       of([](const Case& c) { return c.q1 * c.q2 * conjugate(c.start); })},
      {"bodies 1 and 2 swapped",
       of([](const Case& c) { return conjugate(c.q2) * c.q1 * conjugate(c.start); })},
      {axis_frame, about([](const Case& c) { return c.q1 * c.a1_local; })},
      {axis_frame, about([](const Case& c) { return c.q2 * c.a1_local; })},
      {axis_frame, about([](const Case& c) { return conjugate(c.start) * c.a1_local; })},
      {axis_frame,
       of([](const Case& c) { return c.q2 * conjugate(c.start) * conjugate(c.q1); })},
      {"the axis is not used: p is v.a1_local, not one entry of v",
       about([](const Case&) { return vec3(1, 0, 0); })},
      {"the axis is not used: p is v.a1_local, not one entry of v",
       about([](const Case&) { return vec3(0, 1, 0); })},
      {"the axis is not used: p is v.a1_local, not one entry of v",
       about([](const Case&) { return vec3(0, 0, 1); })}};
  for (const bool swung : {false, true})
    for (const Case& c : angle_cases(swung)) table.cases.push_back(c);
  table.tolerance = 57.3 * difference_tolerance;  // acos of a number near 1 is that rough
  return table;
}

}  // namespace joints::testing
