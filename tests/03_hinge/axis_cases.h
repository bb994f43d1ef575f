// The error of exercise 3.1 as a table of cases with its usual mistakes: the axis.
#pragma once

#include "tests/checker/cases.h"
#include "tests/checker/joint_fixtures.h"

namespace joints::testing {

struct AxisCase {
  std::string words;
  Axis part;
  Pair pair;
};

/// Both bodies turned anyhow, the axes up to 50 degrees apart.
inline std::vector<AxisCase> axis_cases() {
  std::vector<AxisCase> out;
  Random random(31);
  for (int draw = 0; draw < 12; ++draw) {
    Pair pair = uneven_pair();
    pair.body1.q = random.turn();
    pair.body2.q = random.turn();
    const Axis part = AxisFixture::make(pair);
    AxisFixture::move_freely(part, pair, random);
    if (draw >= 3) pair.body2.q = normalize(random.turn(real(0.5)) * pair.body2.q);
    out.push_back({draw < 3 ? "aligned" : "askew", part, pair});
  }
  return out;
}

inline CaseTable<AxisCase> axis_table() {
  using Case = AxisCase;
  const auto with = [](auto a1, auto b_and_c) {
    return [=](const Case& at) {
      const vec3 a = a1(at);
      return Numbers{double(dot(a, b_and_c(at, at.part.b_local))),
                     double(dot(a, b_and_c(at, at.part.c_local)))};
    };
  };
  // where a direction may come from
  const auto a1 = [](const Case& at) { return at.pair.body1.q * at.part.a1_local; };
  const auto a1_local = [](const Case& at) { return at.part.a1_local; };
  const auto on_2 = [](const Case& at, const vec3& local) { return at.pair.body2.q * local; };
  const auto on_1 = [](const Case& at, const vec3& local) { return at.pair.body1.q * local; };
  const auto as_it_is = [](const Case&, const vec3& local) { return local; };
  const auto back = [](const Case& at, const vec3& local) {
    return conjugate(at.pair.body2.q) * local;
  };
  const auto a1_back = [](const Case& at) { return conjugate(at.pair.body1.q) * at.part.a1_local; };
  const auto a1_on_2 = [](const Case& at) { return at.pair.body2.q * at.part.a1_local; };
  const auto a1_point = [=](const Case& at) { return at.pair.body1.x + a1(at); };
  const auto point_2 = [=](const Case& at, const vec3& local) {
    return at.pair.body2.x + on_2(at, local);
  };
  const char* const points = "#of-points a point where a direction belongs: to_world, not "
                             "world_point";
  const auto right = with(a1, on_2);

  CaseTable<Case> table{{"3.1", "the error C of a hinge's axis"}, {"C.b", "C.c"}, {}, {}, {}, {}};
  table.yours = [](const Case& at) {
    const Vector<2> C = at.part.error(at.pair.body1, at.pair.body2);
    return Numbers{double(C[0]), double(C[1])};
  };
  table.right = right;
  table.mistakes = {
      {"#sign-c the sign of C",
       [=](const Case& at) { return Numbers{-right(at)[0], -right(at)[1]}; }},
      {"the two numbers are exchanged: first a1.b, then a1.c",
       [=](const Case& at) { return Numbers{right(at)[1], right(at)[0]}; }},
      {"#c-not-turned b_local and c_local are not turned into the world", with(a1, as_it_is)},
      {"a1_local is not turned into the world", with(a1_local, on_2)},
      {"#all-turned-body-1 nothing is turned, or all by the same body: a1 rides on body 1, b and "
       "c on body 2",
       with(a1_local, as_it_is)},
      {"bodies 1 and 2 swapped: a1 rides on body 1, b and c on body 2", with(a1_on_2, on_1)},
      {"turned the wrong way: to_world, not to_local", with(a1_back, back)},
      {"#cross-product-axes the cross product of the axes: that holds a1.c and -(a1.b)",
       [=](const Case& at) { return Numbers{right(at)[1], -right(at)[0]}; }},
      {"#its-own-axis 0 in every case: it is never written, or cut off by an int, or a2 stands in "
       "the place of a1 (a2 is at right angles to its own b and c)",
       [](const Case&) { return Numbers{0, 0}; }},
      {points, with(a1_point, point_2)},
      {points, with(a1_point, on_2)},
      {points, with(a1, point_2)},
      {"lengths of cross products: C holds the dot products a1.b and a1.c", [=](const Case& at) {
         return Numbers{double(length(cross(a1(at), on_2(at, at.part.b_local)))),
                        double(length(cross(a1(at), on_2(at, at.part.c_local))))};
       }},
      {"the squares: C holds a1.b and a1.c themselves", [=](const Case& at) {
         return Numbers{right(at)[0] * right(at)[0], right(at)[1] * right(at)[1]};
       }},
      {"#1-cos 1 minus the cosine: the vectors are at right angles, so a1.b itself is 0",
       [=](const Case& at) { return Numbers{1 - right(at)[0], 1 - right(at)[1]}; }},
      {"the angle itself: C holds the cosines a1.b and a1.c as they are", [=](const Case& at) {
         return Numbers{std::asin(right(at)[0]), std::asin(right(at)[1])};
       }},
      {"the angle itself: C holds the cosines a1.b and a1.c as they are", [=](const Case& at) {
         return Numbers{std::acos(right(at)[0]), std::acos(right(at)[1])};
       }}};
  table.cases = axis_cases();
  table.tolerance = 10 * rounding;
  return table;
}

}  // namespace joints::testing
