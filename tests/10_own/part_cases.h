// The parts of exercises 10.1 to 10.4: their errors as tables of cases with the usual mistakes, and
// their rows as fixtures beside errors that are right whatever the exercise's own are.
#pragma once

#include <numbers>

#include "chapters/10_own/own.h"
#include "tests/checker/joint_fixtures.h"
#include "tests/checker/pieces.h"

namespace joints::testing {

/// A part at a pose.
template <class Part>
struct PartCase {
  std::string words;
  Part part;
  Pair pair;
};
template <class Part>
using ErrorOf = Call<double(const PartCase<Part>&)>;

/// The error of a part as a table. \param make a part and a pose from random numbers
template <class Part, class Make>
CaseTable<PartCase<Part>> error_table(const Subject& subject, const Make& make,
                                      const ErrorOf<Part>& right,
                                      const std::vector<Mistake<ErrorOf<Part>>>& mistakes) {
  using Case = PartCase<Part>;
  const auto one = [](const ErrorOf<Part>& answer) {
    return [answer](const Case& c) { return Numbers{answer(c)}; };
  };
  CaseTable<Case> table{subject, {"C"}, {}, one(right), {}, {}};
  table.yours = [](const Case& c) {
    return Numbers{double(c.part.error(c.pair.body1, c.pair.body2))};
  };
  for (const auto& [words, does] : mistakes) table.mistakes.push_back({words, one(does)});
  for (unsigned draw = 0; draw < 16; ++draw) {
    Random random(draw + 1);
    table.cases.push_back(make(draw, random));
  }
  table.tolerance = 10 * rounding;
  return table;
}

/// Two bodies turned and placed anyhow.
inline Pair drawn_pair(Random& random) {
  Pair pair = uneven_pair();
  move_together(pair, random);
  pair.body2.q = random.turn();
  return pair;
}
inline vec3 drawn_axis(Random& random) { return normalize(random.vector(1) + vec3(2, 0, 0)); }

/// A row that only turns, with words.
inline std::pair<std::string, Jacobian<1>> turns(const std::string& words, const vec3& w1,
                                                 const vec3& w2) {
  return {words, to_jacobian(Row{vec3(0), w1, vec3(0), w2})};
}

// ---- 10.1 ---------------------------------------------------------------------------------------

inline const char* const told_parallel = "1 - a1.a2 is 0 where the axes are parallel: "
                                         "here they are to be at right angles";

inline CaseTable<PartCase<RightAngle>> right_angle_table() {
  using Case = PartCase<RightAngle>;
  const auto cosine = [](const Case& c) {
    return double(dot(c.pair.body1.q * c.part.a1_local, c.pair.body2.q * c.part.a2_local));
  };
  return error_table<RightAngle>(
      {"10.1", "the error C of a right angle", 1},
      [](unsigned, Random& random) {
        const vec3 a1 = drawn_axis(random);
        return Case{"any pose", {a1, drawn_axis(random)}, drawn_pair(random)};
      },
      cosine,
      {{"the sign: C is a1.a2 itself", [=](const Case& c) { return -cosine(c); }},
       {told_parallel, [=](const Case& c) { return 1 - cosine(c); }},
       {"the length of a1 x a2 is 1 at right angles, and 0 where the axes are parallel",
        [=](const Case& c) { return std::sqrt(1 - cosine(c) * cosine(c)); }},
       {"the angle between the axes: it is pi/2 at right angles, not 0",
        [=](const Case& c) { return std::acos(cosine(c)); }},
       {"the angle less pi/2: its slope is not the row of Eq. 10-2",
        [=](const Case& c) { return std::acos(cosine(c)) - std::numbers::pi / 2; }},
       {"the sign is lost: C must tell to which side the axes lean",
        [=](const Case& c) { return std::abs(cosine(c)); }},
       {"C is squared: its slope is then 0 where C is 0, and the row has no effect",
        [=](const Case& c) { return cosine(c) * cosine(c); }},
       {"both axes are turned with body 1: a2 is fixed in body 2",
        [](const Case& c) {
          return double(dot(c.pair.body1.q * c.part.a1_local, c.pair.body1.q * c.part.a2_local));
        }}});
}

struct RightAngleFixture {
  struct Part : RightAngle {
    real error(const Body& one, const Body& two) const {
      return dot(one.q * a1_local, two.q * a2_local);
    }
  };
  static constexpr Subject J{"10.1", "the row J of a right angle", 2};
  static constexpr std::array rows{"C"};
  static constexpr bool exact_when_broken = true;
  static Part make(const Pair& pair) {
    const vec3 a1 = normalize(vec3(1, 2, real(-0.5)));
    const vec3 a2 = normalize(cross(a1, vec3(real(0.3), 1, 1)));
    return {{to_local(pair.body1, a1), to_local(pair.body2, a2)}};
  }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    pair.body2.x += random.vector(1);
    for (const vec3& axis : {to_world(pair.body2, part.a2_local), to_world(pair.body1,
                                                                           part.a1_local)})
      turn_about(pair.body2, pair.body2.x, rotation(random.uniform(-3, 3) * axis));
  }
  static std::vector<std::pair<std::string, Jacobian<1>>> mistakes(const Part& part,
                                                                   const Pair& pair) {
    const vec3 a1 = to_world(pair.body1, part.a1_local), a2 = to_world(pair.body2, part.a2_local);
    const vec3 n = cross(a1, a2), u = normalize(n), none(0);
    const char* const product = "the axes themselves: a rotation changes a1 by "
                                "w1 x a1, so the row holds a cross product";
    return {turns("the sign of the whole row: cycle the factors of (w1 x a1).a2 once "
                  "more",
                  -n, n),
            turns("w1 and w2 with the same sign: if both bodies turn together, C does "
                  "not change",
                  n, n),
            turns("w1 and w2 with the same sign: if both bodies turn together, C does "
                  "not change",
                  -n, -n),
            turns(product, a2, a1), turns(product, a1, a2), turns(product, a2, -a1),
            turns(product, a1, -a2),
            turns("a unit vector: a1 x a2 becomes shorter as the axes lean", u, -u),
            turns("body 2 is missing: a2 turns as well", n, none),
            turns("body 1 is missing: a1 turns as well", none, -n),
            {"the cross products stand in v1 and v2: this row turns and does not push",
             to_jacobian(Row{n, none, -n, none})},
            turns("the axes are left in body space: take a1 and a2 above",
                  cross(part.a1_local, part.a2_local), -cross(part.a1_local, part.a2_local))};
  }
};

// ---- 10.2 ---------------------------------------------------------------------------------------

/// Wheels on their axles, which have turned many times.
inline PartCase<Gear> gear_case(unsigned draw, Random& random) {
  Pair pair = uneven_pair();
  pair.body1.x = random.vector(1);
  Gear gear{{drawn_axis(random)}, {drawn_axis(random)}, random.uniform(real(0.3), 3)};
  if (draw % 2) gear.ratio = -gear.ratio;
  const real turn1 = random.uniform(-20, 20), turn2 = random.uniform(-20, 20);
  gear.angle1.expected = turn1 + random.uniform(-1, 1);
  gear.angle2.expected = turn2 + random.uniform(-1, 1);
  pair.body1.q = rotation(turn1 * gear.angle1.a1_local);
  pair.body2.q = rotation(turn2 * gear.angle2.a1_local);
  pair.body1.w = random.uniform(-9, 9) * gear.angle1.a1_local;
  pair.body2.w = random.uniform(-9, 9) * gear.angle2.a1_local;
  return {"many turns", gear, pair};
}

inline CaseTable<PartCase<Gear>> gear_table() {
  using Case = PartCase<Gear>;
  const auto of = [](auto combine) {
    return [=](const Case& c) {
      return double(combine(angle_of(c.part.angle1, c.pair.body1),
                            angle_of(c.part.angle2, c.pair.body2), c.part.ratio));
    };
  };
  const real turn = 2 * std::numbers::pi_v<real>;
  return error_table<Gear>(
      {"10.2", "the error C of a gear", 1}, gear_case,
      of([](real a, real b, real ratio) { return b - ratio * a; }),
      {{"the sign of the ratio: it is negative already for wheels that mesh",
        of([](real a, real b, real ratio) { return b + ratio * a; })},
       {"the sign: C grows with the angle of wheel 2",
        of([](real a, real b, real ratio) { return ratio * a - b; })},
       {"the ratio stands with the other wheel: wheel 2 turns `ratio` times as far as "
        "wheel 1",
        of([](real a, real b, real ratio) { return ratio * b - a; })},
       {"the ratio stands with the other wheel: wheel 2 turns `ratio` times as far as "
        "wheel 1",
        of([](real a, real b, real ratio) { return a - ratio * b; })},
       {"divided by the ratio: wheel 2 turns `ratio` times as far as wheel 1",
        of([](real a, real b, real ratio) { return b - a / ratio; })},
       {"the ratio is missing", of([](real a, real b, real) { return b - a; })},
       {"the quotient of the angles: it fails where wheel 1 is at 0",
        of([](real a, real b, real ratio) { return b / a - ratio; })},
       {"C is folded into half a turn: a gear that has slipped a whole turn is wrong, too",
        of([=](real a, real b, real ratio) { return std::remainder(b - ratio * a, turn); })},
       {"the angles are folded into half a turn: they count their turns",
        of([=](real a, real b, real ratio) {
          return std::remainder(b, turn) - ratio * std::remainder(a, turn);
        })}});
}

struct GearFixture {
  struct Part : Gear {
    real error(const Body& one, const Body& two) const {
      return angle_of(angle2, two) - ratio * angle_of(angle1, one);
    }
  };
  static constexpr Subject J{"10.2", "the row J of a gear", 2};
  static constexpr std::array rows{"C"};
  static constexpr bool exact_when_broken = true;
  static constexpr PoseWords broken{"tilted", "the wheels are tilted on their axles"};
  static Part make(const Pair& pair) {
    Part part{{{normalize(vec3(1, 2, real(-0.5)))}, {normalize(vec3(2, -1, 1))}, real(-1.7)}};
    part.angle1.start = pair.body1.q;
    part.angle2.start = pair.body2.q;
    return part;
  }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    const real turn = random.uniform(real(-1.5), real(1.5));  // less than half a turn of wheel 2
    pair.body1.q = rotation(turn * part.angle1.a1_local) * part.angle1.start;
    pair.body2.q = rotation(part.ratio * turn * part.angle2.a1_local) * part.angle2.start;
  }
  static std::vector<std::pair<std::string, Jacobian<1>>> mistakes(const Part& part,
                                                                   const Pair& pair) {
    const vec3 g1 = slope_of(part.angle1, pair.body1), g2 = slope_of(part.angle2, pair.body2);
    const real ratio = part.ratio;
    const vec3 none(0);
    const char* const other = "the ratio stands with the other wheel";
    return {turns("the sign of the ratio", ratio * g1, g2),
            turns("the sign of the whole row", ratio * g1, -g2),
            turns(other, -g1, ratio * g2), turns(other, g1, -ratio * g2),
            turns("divided by the ratio", -g1 / ratio, g2),
            turns("the ratio is missing", -g1, g2),
            turns("g1 and g2 are exchanged: each wheel has its own axle",
                  -ratio * g2, g1),
            turns("g2 for both wheels: each has its own axle", -ratio * g2, g2),
            turns("g1 for both wheels: each has its own axle", -ratio * g1, g1),
            turns("the axles in the place of g1 and g2: that is exact only while "
                  "the wheels are straight on them",
                  -ratio * part.angle1.a1_local, part.angle2.a1_local),
            turns("wheel 1 is missing", none, g2),
            turns("wheel 2 is missing", -ratio * g1, none),
            {"g1 and g2 stand in v1 and v2: a wheel turns",
             to_jacobian(Row{-ratio * g1, none, g2, none})}};
  }
};

/// What the third part of exercise 10.2 expects, as a table.
inline CaseTable<PartCase<Gear>> count_table() {
  using Case = PartCase<Gear>;
  static constexpr real h = real(0.05);
  const auto of = [](auto expect) {
    return [=](const Case& c) {
      Numbers out;
      const std::array wheels{std::pair(&c.part.angle1, &c.pair.body1),
                              std::pair(&c.part.angle2, &c.pair.body2)};
      for (const auto& [angle, body] : wheels)
        out.push_back(double(expect(angle_of(*angle, *body), dot(slope_of(*angle, *body), body->w),
                                    angle->expected)));
      return out;
    };
  };
  CaseTable<Case> table{{"10.2", "the angles that are expected after h = 0.05 s", 3},
                        {"angle1.expected", "angle2.expected"}, {}, {}, {}, {}};
  table.yours = [](const Case& c) {
    Gear gear = c.part;
    gear.count(c.pair.body1, c.pair.body2, h);
    return Numbers{double(gear.angle1.expected), double(gear.angle2.expected)};
  };
  table.right = of([](real angle, real rate, real) { return angle + h * rate; });
  table.mistakes = {
      {"the angle now: in a fast step a wheel turns by more than half a turn, so the "
       "rate belongs to it (Eq. 3-12)",
       of([](real angle, real, real) { return angle; })},
      {"the sign of the rate: the step is still to come",
       of([](real angle, real rate, real) { return angle - h * rate; })},
      {"h is missing: a rate is no angle",
       of([](real angle, real rate, real) { return angle + rate; })},
      {"the old expected value is moved on and the angle never measured: its "
       "errors add up",
       of([](real, real rate, real expected) { return expected + h * rate; })},
      {"the angle is missing", of([](real, real rate, real) { return h * rate; })},
      {"nothing is set", of([](real, real, real expected) { return expected; })},
      {"the length of w has no sign: the rate is g.w",
       of([](real angle, real rate, real) { return angle + h * std::abs(rate); })}};
  for (unsigned draw = 0; draw < 12; ++draw) {
    Random random(draw + 41);
    table.cases.push_back(gear_case(draw, random));
  }
  table.tolerance = 100 * rounding;
  return table;
}

}  // namespace joints::testing
