// Exercises 3.1 and 3.2 as tables of cases, each with its usual mistakes: the axis, coupling.
#pragma once

#include "tests/checker/cases.h"
#include "tests/checker/joint_fixtures.h"

namespace joints::testing {

// ---- 3.1 the error of the axis ------------------------------------------------------------------

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
  const auto right = with(a1, on_2);

  CaseTable<Case> table{{"3.1", "the error C of a hinge's axis"}, {"C.b", "C.c"}, {}, {}, {}, {}};
  table.yours = [](const Case& at) {
    const Vector<2> C = at.part.error(at.pair.body1, at.pair.body2);
    return Numbers{double(C[0]), double(C[1])};
  };
  table.right = right;
  table.mistakes = {
      {"the sign of C", [=](const Case& at) { return Numbers{-right(at)[0], -right(at)[1]}; }},
      {"the two numbers are exchanged: first a1.b, then a1.c",
       [=](const Case& at) { return Numbers{right(at)[1], right(at)[0]}; }},
      {"b_local and c_local are not turned into the world", with(a1, as_it_is)},
      {"a1_local is not turned into the world", with(a1_local, on_2)},
      {"nothing is turned, or all by the same body: a1 rides on body 1, b and c on body 2",
       with(a1_local, as_it_is)},
      {"bodies 1 and 2 swapped: a1 rides on body 1, b and c on body 2", with(a1_on_2, on_1)},
      {"turned the wrong way: to_world, not to_local", with(a1_back, back)},
      {"the cross product of the axes: that holds a1.c and -(a1.b)",
       [=](const Case& at) { return Numbers{right(at)[1], -right(at)[0]}; }},
      {"a2 with its own b and c is always 0: take a1, the axis of body 1",
       [](const Case&) { return Numbers{0, 0}; }},
      {"the same number twice",
       [=](const Case& at) { return Numbers{right(at)[0], right(at)[0]}; }},
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

// ---- 3.2 coupling -------------------------------------------------------------------------------

struct RowsCase {
  std::string words;
  Row a, b;
  Pair pair;
};

/// Rows with numbers in every block between two uneven bodies that are turned.
inline std::vector<RowsCase> rows_cases() {
  std::vector<RowsCase> out;
  Random random(32);
  const auto row = [&] {
    return Row{random.vector(1), random.vector(1), random.vector(1), random.vector(1)};
  };
  for (int draw = 0; draw < 8; ++draw) {
    Pair pair = uneven_pair();
    move_together(pair, random);
    const Row a = row(), b = row();
    out.push_back({"any rows", a, b, pair});
  }
  return out;
}

inline CaseTable<RowsCase> coupling_table() {
  using Case = RowsCase;
  struct Mass {
    real linear;
    mat3 angular;
  };
  const auto product = [](const Row& a, const Mass& m1, const Mass& m2, const Row& b) {
    return Numbers{double(dot(a.v1, m1.linear * b.v1) + dot(a.w1, m1.angular * b.w1) +
                          dot(a.v2, m2.linear * b.v2) + dot(a.w2, m2.angular * b.w2))};
  };
  const auto inverse_of = [](const Body& body) {
    return Mass{body.inverse_mass, inverse_inertia(body)};
  };
  // the same for both bodies: what stands in the place of their inverse mass and inertia
  const auto with = [=](auto mass) {
    return [=](const Case& c) {
      return product(c.a, mass(c.pair.body1), mass(c.pair.body2), c.b);
    };
  };
  const auto turn_of = [](const Case& c, bool second) {
    return double(second ? dot(c.a.w2, inverse_inertia(c.pair.body2) * c.b.w2)
                         : dot(c.a.w1, inverse_inertia(c.pair.body1) * c.b.w1));
  };
  const auto scaled = [=](real one, real two, real linear, real angular) {
    return [=](const Case& c) {
      Mass m1 = inverse_of(c.pair.body1), m2 = inverse_of(c.pair.body2);
      m1 = {one * linear * m1.linear, one * angular * m1.angular};
      m2 = {two * linear * m2.linear, two * angular * m2.angular};
      return product(c.a, m1, m2, c.b);
    };
  };
  const auto mass = [](const Body& body) { return body.is_static() ? 0 : 1 / body.inverse_mass; };
  const auto inertia = [](const Body& body) {
    return body.is_static() ? mat3(0) : mat3(inverse(inverse_inertia(body)));
  };
  const auto local = [](const Body& body) {
    Body straight = body;
    straight.q = quat(1, 0, 0, 0);
    return inverse_inertia(straight);
  };

  CaseTable<Case> table{{"3.2", "the coupling of two rows"}, {"a M^-1 b^T"}, {}, {}, {}, {}};
  table.yours = [](const Case& c) {
    return Numbers{double(coupling(c.a, c.b, c.pair.body1, c.pair.body2))};
  };
  table.right = with(inverse_of);
  table.mistakes = {
      {"masses where inverse masses belong: M^-1 divides by the mass",
       with([=](const Body& body) { return Mass{mass(body), inverse_inertia(body)}; })},
      {"masses and inertias where their inverses belong",
       with([=](const Body& body) { return Mass{mass(body), inertia(body)}; })},
      {"inertia where inverse inertia belongs",
       with([=](const Body& body) { return Mass{body.inverse_mass, inertia(body)}; })},
      {"body-space inertia: take inverse_inertia(body)",
       with([=](const Body& body) { return Mass{body.inverse_mass, local(body)}; })},
      {"inverse mass where inverse inertia belongs",
       with([](const Body& body) { return Mass{body.inverse_mass, mat3(body.inverse_mass)}; })},
      {"the turn of body 2 is missing: the blocks w2",
       [=](const Case& c) { return Numbers{table.right(c)[0] - turn_of(c, true)}; }},
      {"the turn of body 1 is missing: the blocks w1",
       [=](const Case& c) { return Numbers{table.right(c)[0] - turn_of(c, false)}; }},
      {"the push of body 2 is missing: the blocks v2",
       [=](const Case& c) {
         return Numbers{table.right(c)[0] -
                        double(c.pair.body2.inverse_mass * dot(c.a.v2, c.b.v2))};
       }},
      {"the push of body 1 is missing: the blocks v1",
       [=](const Case& c) {
         return Numbers{table.right(c)[0] -
                        double(c.pair.body1.inverse_mass * dot(c.a.v1, c.b.v1))};
       }},
      {"each product belongs to its own body's inverse mass, not to the sum of both",
       [=](const Case& c) {
         const real sum = c.pair.body1.inverse_mass + c.pair.body2.inverse_mass;
         return product(c.a, {sum, inverse_inertia(c.pair.body1)},
                        {sum, inverse_inertia(c.pair.body2)}, c.b);
       }},
      {"M^-1 is missing", with([](const Body&) { return Mass{1, mat3(1)}; })},
      {"the inverse masses are missing",
       with([](const Body& body) { return Mass{1, inverse_inertia(body)}; })},
      {"the inverse inertia is missing",
       with([](const Body& body) { return Mass{body.inverse_mass, mat3(1)}; })},
      {"body 1 is missing", scaled(0, 1, 1, 1)},
      {"body 2 is missing", scaled(1, 0, 1, 1)},
      {"the turns are missing: the blocks w1 and w2", scaled(1, 1, 1, 0)},
      {"the linear blocks v1 and v2 are missing", scaled(1, 1, 0, 1)},
      {"the sign of body 1's share: the shares of both bodies are added", scaled(-1, 1, 1, 1)},
      {"the sign of body 2's share: the shares of both bodies are added", scaled(1, -1, 1, 1)},
      {"the sign of the turns' share: all four terms are added", scaled(1, 1, 1, -1)},
      {"the sign of the result", scaled(-1, -1, 1, 1)},
      {"a factor of 0.5", scaled(real(0.5), real(0.5), 1, 1)},
      {"a factor of 2", scaled(2, 2, 1, 1)},
      {"the row a with itself: one side belongs to b",
       [=](const Case& c) { return table.right({"", c.a, c.a, c.pair}); }},
      {"the row b with itself: one side belongs to a",
       [=](const Case& c) { return table.right({"", c.b, c.b, c.pair}); }},
      {"mass and inertia of the other body",
       [=](const Case& c) {
         return product(c.a, inverse_of(c.pair.body2), inverse_of(c.pair.body1), c.b);
       }},
      {"the inertia of the other body",
       [=](const Case& c) {
         const Body &one = c.pair.body1, &two = c.pair.body2;
         return product(c.a, {one.inverse_mass, inverse_inertia(two)},
                        {two.inverse_mass, inverse_inertia(one)}, c.b);
       }},
      {"blocks of body 1 with those of body 2: v1 with v1, w1 with w1",
       [=](const Case& c) {
         const Row swapped{c.b.v2, c.b.w2, c.b.v1, c.b.w1};
         return product(c.a, inverse_of(c.pair.body1), inverse_of(c.pair.body2), swapped);
       }},
      {"one over the result: that is an effective mass",
       [=](const Case& c) { return Numbers{1 / table.right(c)[0]}; }},
      {"one term of body 1 and one of body 2: each body has two",
       [=](const Case& c) {
         return Numbers{double(c.pair.body1.inverse_mass * dot(c.a.v1, c.b.v1) +
                               dot(c.a.w2, inverse_inertia(c.pair.body2) * c.b.w2))};
       }}};
  table.cases = rows_cases();
  table.tolerance = 10 * rounding;
  return table;
}

}  // namespace joints::testing
