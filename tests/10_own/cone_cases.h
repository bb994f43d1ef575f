// The cone of exercise 10.4: its error and, at swing 0, the direction of its row as tables of
// cases; its row elsewhere as a fixture.
#pragma once

#include "tests/10_own/part_cases.h"

namespace joints::testing {

inline CaseTable<PartCase<Cone>> cone_table() {
  using Case = PartCase<Cone>;
  const auto of = [](auto combine) {
    return [=](const Case& c) {
      const vec3 a1 = c.pair.body1.q * c.part.a1_local, a2 = c.pair.body2.q * c.part.a2_local;
      return double(combine(length(cross(a1, a2)), dot(a1, a2), c.part.limit));
    };
  };
  const auto bound = [](real cosine) { return std::clamp(cosine, real(-1), real(1)); };
  auto table = error_table<Cone>(
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
        return Case{swing < real(0.01) ? "nearly along the axis" : "any swing",
                    {to_local(pair.body1, a), to_local(pair.body2, tilted),
                     random.uniform(real(0.3), 2)},
                    pair};
      },
      of([](real sine, real cosine, real limit) { return limit - std::atan2(sine, cosine); }),
      {{"the sign: C is positive inside the cone",
        of([](real sine, real cosine, real limit) { return std::atan2(sine, cosine) - limit; })},
       {"the cosines are compared: C is an angle here, whose slope does not vanish at "
        "small swings",
        of([](real, real cosine, real limit) { return cosine - std::cos(limit); })},
       {"an arcsine ends at a quarter turn: beyond it the swing would shrink again",
        of([](real sine, real, real limit) { return limit - std::asin(std::min(sine, real(1))); })},
       {"the sine of the swing: it shrinks again beyond a quarter turn",
        of([](real sine, real, real limit) { return limit - sine; })},
       {"an arccosine loses half of the digits at small swings: use atan2 of sine and "
        "cosine",
        of([=](real, real cosine, real limit) { return limit - std::acos(bound(cosine)); })},
       {"atan2 takes the sine first",
        of([](real sine, real cosine, real limit) { return limit - std::atan2(cosine, sine); })},
       {"the limit is missing",
        of([](real sine, real cosine, real) { return std::atan2(sine, cosine); })},
       {"half of the limit: it is the angle from the axis to the edge of the cone",
        of([](real sine, real cosine, real limit) {
          return limit / 2 - std::atan2(sine, cosine);
        })},
       {"C is never negative here: beyond the limit it has to be, or nothing pushes back",
        of([](real sine, real cosine, real limit) {
          return std::max(limit - std::atan2(sine, cosine), real(0));
        })}});
  return table;
}

struct ConeFixture {
  struct Part : Cone {
    real error(const Body& one, const Body& two) const {
      const vec3 a1 = one.q * a1_local, a2 = two.q * a2_local;
      return limit - 2 * std::atan2(length(a2 - a1), length(a2 + a1));
    }
  };
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
  static std::vector<std::pair<std::string, Jacobian<1>>> mistakes(const Part& part,
                                                                   const Pair& pair) {
    const vec3 a1 = to_world(pair.body1, part.a1_local), a2 = to_world(pair.body2, part.a2_local);
    const vec3 m = cross(a1, a2), n = normalize(m), none(0);
    const vec3 across = normalize(a2 - dot(a1, a2) * a1);
    return {turns("the sign of the whole row: C shrinks as the swing grows", -n, n),
            turns("a1 x a2 has the length of the sine: the swing is an angle, so the row "
                  "holds a unit vector",
                  m, -m),
            turns("a1 x a2 is no unit vector, and the sign is wrong as well",
                  -m, m),
            turns("w1 and w2 with the same sign: if both bodies turn together, C does "
                  "not change",
                  n, n),
            turns("an axis itself: a rotation about it does not change the swing",
                  a1, -a1),
            turns("an axis itself: a rotation about it does not change the swing",
                  a2, -a2),
            turns("a vector in the plane of the axes: the swing turns about their "
                  "cross product",
                  across, -across),
            turns("body 2 is missing", n, none),
            turns("body 1 is missing", none, -n),
            {"n stands in v1 and v2: this row turns and does not push",
             to_jacobian(Row{n, none, -n, none})}};
  }
};

// ---- the direction at swing 0 -------------------------------------------------------------------

/// The row at swing 0 as six numbers, w1 and w2, while the bodies rotate.
inline CaseTable<PartCase<Cone>> upright_table() {
  using Case = PartCase<Cone>;
  const auto row = [](auto direction) {
    return [=](const Case& c) {
      const vec3 a1 = c.pair.body1.q * c.part.a1_local;
      const vec3 n = direction(a1, c.pair.body1.w, c.pair.body2.w);
      return Numbers{double(n.x), double(n.y), double(n.z), -double(n.x), -double(n.y),
                     -double(n.z)};
    };
  };
  const auto across = [](const vec3& w, const vec3& a1) { return w - dot(w, a1) * a1; };
  const auto unit_or_none = [](const vec3& a) { return direction(a); };
  CaseTable<Case> table{{"10.4", "the row J of a cone at swing 0", 2}, {"w1", "w2"}, {}, {}, {},
                        {}};
  table.yours = [](const Case& c) {
    const Row J = c.part.jacobian(c.pair.body1, c.pair.body2);
    return Numbers{double(J.w1.x), double(J.w1.y), double(J.w1.z),
                   double(J.w2.x), double(J.w2.y), double(J.w2.z)};
  };
  table.right = row([=](const vec3& a1, const vec3& w1, const vec3& w2) {
    return unit_or_none(across(w2 - w1, a1));
  });
  table.mistakes = {
      {"the part of w2 - w1 along a1 is in it: a twist does not change the swing",
       row([=](const vec3&, const vec3& w1, const vec3& w2) { return unit_or_none(w2 - w1); })},
      {"body 1 rotates as well: w2 - w1",
       row([=](const vec3& a1, const vec3&, const vec3& w2) {
         return unit_or_none(across(w2, a1));
       })},
      {"the sign of w2 - w1: with it the row drives the bodies through the limit",
       row([=](const vec3& a1, const vec3& w1, const vec3& w2) {
         return unit_or_none(across(w1 - w2, a1));
       })},
      {"the row holds a unit vector at swing 0, too",
       row([=](const vec3& a1, const vec3& w1, const vec3& w2) { return across(w2 - w1, a1); })},
      {"zero at swing 0: a fast body then passes the limit in one step",
       row([](const vec3&, const vec3&, const vec3&) { return vec3(0); })},
      {"a direction that does not depend on the motion: where the bodies rotate "
       "across it, the row has no effect",
       row([=](const vec3& a1, const vec3&, const vec3&) {
         return unit_or_none(cross(a1, vec3(1, 0, 0)));
       })},
      {"a direction that does not depend on the motion: where the bodies rotate "
       "across it, the row has no effect",
       row([=](const vec3& a1, const vec3&, const vec3&) {
         return unit_or_none(cross(a1, vec3(0, 1, 0)));
       })},
      {"a direction that does not depend on the motion: where the bodies rotate "
       "across it, the row has no effect",
       row([](const vec3&, const vec3&, const vec3&) { return vec3(1, 0, 0); })},
      {"the direction in which the axis moves: the row holds the axis about "
       "which it turns",
       row([=](const vec3& a1, const vec3& w1, const vec3& w2) {
         return unit_or_none(cross(w2 - w1, a1));
       })}};
  for (unsigned draw = 0; draw < 12; ++draw) {
    Random random(draw + 71);
    Pair pair = drawn_pair(random);
    const vec3 a = drawn_axis(random);
    pair.body1.w = random.vector(5);
    pair.body2.w = random.vector(5);
    const Cone cone{to_local(pair.body1, a), to_local(pair.body2, a), 1};
    table.cases.push_back({"rotating", cone, pair});
  }
  table.tolerance = is_float ? 1e-3 : 1e-8;
  return table;
}

}  // namespace joints::testing
