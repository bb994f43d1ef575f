// The parts of exercises 10.1 to 10.4: their errors as tables of cases, and their rows as fixtures
// beside errors that are right whatever the exercise's own are.
#pragma once

#include "chapters/10_own/own.h"
#include "tests/checker/cases.h"
#include "tests/checker/joint_fixtures.h"

namespace joints::testing {

/// A part at a pose.
template <class Part>
struct PartCase {
  std::string words;
  Part part;
  Pair pair;
};

/// The error of a part as a table. \param make a part and a pose from random numbers
template <class Part, class Make, class Right>
CaseTable<PartCase<Part>> error_table(const Subject& subject, const Make& make,
                                      const Right& right) {
  using Case = PartCase<Part>;
  CaseTable<Case> table{subject, {"C"}};
  judge(table, +[](const Part& part, const Body& body1, const Body& body2) {
    return part.error(body1, body2);
  }, [](auto error, const Case& c) {
    return Numbers{double(error(c.part, c.pair.body1, c.pair.body2))};
  });
  table.right = [=](const Case& c) { return Numbers{double(right(c.part, c.pair))}; };
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

// ---- 10.1 ---------------------------------------------------------------------------------------

inline CaseTable<PartCase<RightAngle>> right_angle_table() {
  return error_table<RightAngle>(
      {"10.1", "the error C of a right angle", 1},
      [](unsigned, Random& random) {
        const vec3 a1 = drawn_axis(random);
        return PartCase<RightAngle>{"any pose", {a1, drawn_axis(random)}, drawn_pair(random)};
      },
      [](const RightAngle& part, const Pair& pair) {
        return dot(pair.body1.q * part.a1_local, pair.body2.q * part.a2_local);
      });
}

struct RightAngleFixture {
  struct Part : RightAngle {
    real error(const Body& one, const Body& two) const {
      return dot(one.q * a1_local, two.q * a2_local);
    }
  };
  using Exercise = RightAngle;
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
  return error_table<Gear>({"10.2", "the error C of a gear", 1}, gear_case,
                           [](const Gear& gear, const Pair& pair) {
                             return angle_of(gear.angle2, pair.body2) -
                                    gear.ratio * angle_of(gear.angle1, pair.body1);
                           });
}

struct GearFixture {
  struct Part : Gear {
    real error(const Body& one, const Body& two) const {
      return angle_of(angle2, two) - ratio * angle_of(angle1, one);
    }
  };
  using Exercise = Gear;
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
};

/// What the third part of exercise 10.2 expects, of wheels that wobble on their axles.
inline CaseTable<PartCase<Gear>> count_table() {
  using Case = PartCase<Gear>;
  static constexpr real h = real(0.05);
  CaseTable<Case> table{{"10.2", "the angles that are expected after h = 0.05 s", 3},
                        {"angle1.expected", "angle2.expected"}};
  judge(table, +[](const Gear& gear, const Body& body1, const Body& body2, real h) {
    Gear counted = gear;
    counted.count(body1, body2, h);
    return counted;
  }, [](auto count, const Case& c) {
    const Gear gear = count(c.part, c.pair.body1, c.pair.body2, h);
    return Numbers{double(gear.angle1.expected), double(gear.angle2.expected)};
  });
  table.right = [](const Case& c) {
    const auto after = [](const HingeAngle& angle, const Body& body) {
      const vec3 travel = h * body.w;
      return double(angle_of(angle, body) + dot(travel, slope_of(angle, body)));
    };
    return Numbers{after(c.part.angle1, c.pair.body1), after(c.part.angle2, c.pair.body2)};
  };
  for (unsigned draw = 0; draw < 12; ++draw) {
    Random random(draw + 41);
    table.cases.push_back(gear_case(draw, random));
    for (Body* body : {&table.cases.back().pair.body1, &table.cases.back().pair.body2}) {
      body->q = normalize(rotation(random.vector(real(0.3))) * body->q);
      body->w = random.vector(6);
    }
  }
  table.tolerance = 100 * rounding;
  return table;
}

}  // namespace joints::testing
