// The cone of exercise 10.4: its error and, at small swings, the direction of its row as tables
// of cases; its row elsewhere as a fixture.
#pragma once

#include "tests/10_own/part_cases.h"

namespace joints::testing {

/// The swing of a cone, from half angles.
inline real swing_of(const Cone& cone, const Pair& pair) {
  const vec3 a1 = pair.body1.q * cone.a1_local, a2 = pair.body2.q * cone.a2_local;
  return 2 * std::atan2(length(a2 - a1), length(a2 + a1));
}

inline CaseTable<PartCase<Cone>> cone_table() {
  return error_table<Cone>(
      {"10.4", "the error C of a cone", 1},
      [](unsigned draw, Random& random) {
        Pair pair = drawn_pair(random);
        const vec3 a = drawn_axis(random);
        const real swing = draw == 3   ? real(is_float ? 1e-3 : 1e-8)
                           : draw == 5 ? real(2.9)
                                       : random.uniform(real(0.05), real(2.2));
        const vec3 across = normalize(cross(a, random.vector(1) + vec3(0, 0, 3)));
        pair.body2.q = normalize(rotation(swing * across) * random.turn());
        const vec3 tilted = rotation(swing * across) * a;
        return PartCase<Cone>{swing < real(0.01) ? "nearly along the axis" : "any swing",
                              {to_local(pair.body1, a), to_local(pair.body2, tilted),
                               random.uniform(real(0.3), 2)},
                              pair};
      },
      [](const Cone& cone, const Pair& pair) { return cone.limit - swing_of(cone, pair); });
}

struct ConeFixture {
  struct Part : Cone {
    real error(const Body& one, const Body& two) const {
      return limit - swing_of(*this, {one, two});
    }
  };
  using Exercise = Cone;
  static constexpr Subject J{"10.4", "the row J of a cone", 2};
  static constexpr std::array rows{"C"};
  static constexpr bool exact_when_broken = true;
  static constexpr PoseWords broken{"beyond", "inside the cone or beyond it"};
  static Part make(const Pair& pair) {
    const vec3 a = normalize(vec3(1, real(0.4), -1));
    const vec3 tilted = rotation(real(0.8) * normalize(cross(a, vec3(0, 1, 1)))) * a;
    return {{to_local(pair.body1, a), to_local(pair.body2, tilted), real(0.8)}};
  }
  static void move_freely(const Part& part, Pair& pair, Random& random) {
    pair.body2.x += random.vector(1);
    for (const vec3& axis :
         {to_world(pair.body2, part.a2_local), to_world(pair.body1, part.a1_local)})
      turn_about(pair.body2, pair.body2.x, rotation(random.uniform(-3, 3) * axis));
  }
};

// ---- the direction at swing 0 -------------------------------------------------------------------

/// The row at swing 0 and at small ones as six numbers, w1 and w2, while the bodies rotate.
inline CaseTable<PartCase<Cone>> upright_table() {
  using Case = PartCase<Cone>;
  CaseTable<Case> table{{"10.4", "the row J of a cone at small swings", 2}, {"w1", "w2"}};
  judge(table, +[](const Cone& cone, const Body& body1, const Body& body2) {
    return cone.jacobian(body1, body2);
  }, [](auto jacobian, const Case& c) {
    const Row J = jacobian(c.part, c.pair.body1, c.pair.body2);
    return Numbers{double(J.w1.x), double(J.w1.y), double(J.w1.z),
                   double(J.w2.x), double(J.w2.y), double(J.w2.z)};
  });
  table.right = [](const Case& c) {
    const auto& [one, two] = c.pair;
    const vec3 a1 = one.q * c.part.a1_local, a2 = two.q * c.part.a2_local, w = two.w - one.w;
    const vec3 n = direction(c.words == "rotating" ? cross(a1, cross(w, a1)) : cross(a1, a2));
    return Numbers{double(n.x), double(n.y), double(n.z), -double(n.x), -double(n.y),
                   -double(n.z)};
  };
  for (unsigned draw = 0; draw < 12; ++draw) {
    Random random(draw + 71);
    Pair pair = drawn_pair(random);
    const vec3 a = drawn_axis(random);
    pair.body1.w = random.vector(5);
    pair.body2.w = random.vector(5);
    const Cone cone{to_local(pair.body1, a), to_local(pair.body2, a), 1};
    table.cases.push_back({"rotating", cone, pair});
    const double swing = std::pow(10, -1 - int(draw % 5));
    if (draw < 7 || is_float) continue;
    Body& body = table.cases.back().pair.body2;
    body.q = normalize(rotation(real(swing) * normalize(cross(a, random.vector(1)))) * body.q);
    table.cases.back().words = "swung by " + short_number(swing);
  }
  table.tolerance = is_float ? 1e-3 : 1e-8;
  return table;
}

}  // namespace joints::testing
