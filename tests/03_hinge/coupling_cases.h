// Exercise 3.2 as a table of cases with its usual mistakes: the coupling of two rows.
#pragma once

#include "tests/checker/cases.h"
#include "tests/checker/joint_fixtures.h"

namespace joints::testing {

struct RowsCase {
  std::string words;
  Row a, b;
  Pair pair;
};

/// Rows with numbers in every block between two uneven bodies that are turned; one of them little,
/// the last four with a static body.
inline std::vector<RowsCase> rows_cases() {
  std::vector<RowsCase> out;
  Random random(32);
  const auto row = [&] {
    return Row{random.vector(1), random.vector(1), random.vector(1), random.vector(1)};
  };
  for (int draw = 0; draw < 12; ++draw) {
    Pair pair = uneven_pair();
    move_together(pair, random);
    Row a = row(), b = row();
    if (draw == 7) a = {real(1e-3) * a.v1, real(1e-3) * a.w1, real(1e-3) * a.v2, real(1e-3) * a.w2};
    if (draw >= 8) {
      Body& wall = draw % 2 ? pair.body2 : pair.body1;
      wall = static_body(wall.x, wall.q);
    }
    out.push_back({draw < 8 ? "any rows" : draw % 2 ? "2 static" : "1 static", a, b, pair});
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
    return Numbers{double(product_K(Jacobian<2>{{a, b}}, m1.linear, m1.angular, m2.linear,
                                    m2.angular)[0][1])};
  };
  const auto inverse_of = [](const Body& body) {
    return Mass{body.inverse_mass, inverse_inertia(body)};
  };
  // what stands in the place of the bodies' inverse masses and inertias
  const auto of_bodies = [=](auto masses) {
    return [=](const Case& c) {
      const auto [one, two] = masses(c.pair.body1, c.pair.body2);
      return product(c.a, one, two, c.b);
    };
  };
  const auto with = [=](auto mass) {
    return of_bodies([=](const Body& one, const Body& two) {
      return std::pair(mass(one), mass(two));
    });
  };
  const auto with_blocks = [=](auto change) {
    return [=](Case c) {
      change(c.a, c.b);
      return product(c.a, inverse_of(c.pair.body1), inverse_of(c.pair.body2), c.b);
    };
  };
  // factors of the four terms
  const auto scaled = [=](real v1, real w1, real v2, real w2) {
    return of_bodies([=](const Body& one, const Body& two) {
      return std::pair(Mass{v1 * one.inverse_mass, w1 * inverse_inertia(one)},
                       Mass{v2 * two.inverse_mass, w2 * inverse_inertia(two)});
    });
  };
  const auto mass = [](const Body& body) { return body.is_static() ? 0 : 1 / body.inverse_mass; };
  const auto inertia = [](const Body& body) {
    return body.is_static() ? mat3(0) : mat3(inverse(inverse_inertia(body)));
  };
  // the same where nobody has thought of a static body
  const auto divided = [=](const Case& c, auto turns) {
    const Body &one = c.pair.body1, &two = c.pair.body2;
    const real linear = dot(c.a.v1, c.b.v1) / one.inverse_mass +
                        dot(c.a.v2, c.b.v2) / two.inverse_mass;
    return Numbers{double(linear) + product(c.a, {0, turns(one)}, {0, turns(two)}, c.b)[0]};
  };
  const auto turned = [](Body body, const quat& q) {
    body.q = q;
    return inverse_inertia(body);
  };
  const auto local = [=](const Body& body) { return turned(body, quat(1, 0, 0, 0)); };

  CaseTable<Case> table{{"3.2", "the coupling of two rows"}, {"a M^-1 b^T"}, {}, {}, {}, {}};
  table.yours = [](const Case& c) {
    return Numbers{double(coupling(c.a, c.b, c.pair.body1, c.pair.body2))};
  };
  table.right = with(inverse_of);
  const char* const masses = "#mass-inverse-mass masses where inverse masses belong: M^-1 divides "
                             "by the mass";
  const char* const all = "masses and inertias where their inverses belong";
  table.mistakes = {
      {masses, with([=](const Body& body) { return Mass{mass(body), inverse_inertia(body)}; })},
      {masses, [=](const Case& c) { return divided(c, inverse_inertia); }},
      {all, with([=](const Body& body) { return Mass{mass(body), inertia(body)}; })},
      {all, [=](const Case& c) {
         return divided(c, [](const Body& body) { return mat3(inverse(inverse_inertia(body))); });
       }},
      {"inertia where inverse inertia belongs",
       with([=](const Body& body) { return Mass{body.inverse_mass, inertia(body)}; })},
      {"#body-space-inertia body-space inertia: take inverse_inertia(body)",
       with([=](const Body& body) { return Mass{body.inverse_mass, local(body)}; })},
      {"body-space inertia of body 1: take inverse_inertia(body)",
       of_bodies([=](const Body& one, const Body& two) {
         return std::pair(Mass{one.inverse_mass, local(one)}, inverse_of(two));
       })},
      {"#local-inertia-body-2 body-space inertia of body 2: take inverse_inertia(body)",
       of_bodies([=](const Body& one, const Body& two) {
         return std::pair(inverse_of(one), Mass{two.inverse_mass, local(two)});
       })},
      {"#inertia-turned-wrong-way the inertia is turned the wrong way round: R I^-1 R^T, not R^T "
       "I^-1 R",
       with([=](const Body& body) {
         return Mass{body.inverse_mass, turned(body, conjugate(body.q))};
       })},
      {"#local-rows rows in the body's axes with an inertia in the world's: inverse_inertia(body) "
       "takes the rows as they are",
       with([=](const Body& body) {
         const mat3 R = glm::mat3_cast(body.q);
         return Mass{body.inverse_mass, R * inverse_inertia(body) * inverse(R)};
       })},
      {"#only-local-side one side is turned into the body's axes and not the other: take "
       "inverse_inertia(body)",
       with([=](const Body& body) {
         return Mass{body.inverse_mass, local(body) * transpose(glm::mat3_cast(body.q))};
       })},
      {"#w-terms-without-inertia the inverse inertia of body 1 is missing",
       of_bodies([=](const Body& one, const Body& two) {
         return std::pair(Mass{one.inverse_mass, mat3(1)}, inverse_of(two));
       })},
      {"the inverse inertia of body 2 is missing",
       of_bodies([=](const Body& one, const Body& two) {
         return std::pair(inverse_of(one), Mass{two.inverse_mass, mat3(1)});
       })},
      {"the inertia is turned by R alone: R I^-1 R^T", with([=](const Body& body) {
         return Mass{body.inverse_mass, glm::mat3_cast(body.q) * local(body)};
       })},
      {"inverse mass where inverse inertia belongs",
       with([](const Body& body) { return Mass{body.inverse_mass, mat3(body.inverse_mass)}; })},
      {"each product belongs to its own body's inverse mass, not to the sum of both",
       of_bodies([](const Body& one, const Body& two) {
         const real sum = one.inverse_mass + two.inverse_mass;
         return std::pair(Mass{sum, inverse_inertia(one)}, Mass{sum, inverse_inertia(two)});
       })},
      {"the inverse mass multiplies the turn, too: each product has its own factor",
       with([](const Body& body) {
         return Mass{body.inverse_mass, body.inverse_mass * inverse_inertia(body)};
       })},
      {"only the diagonal of the inverse inertia is used: it has nine entries",
       with([](const Body& body) {
         const mat3 I = inverse_inertia(body);
         return Mass{body.inverse_mass, mat3(I[0][0], 0, 0, 0, I[1][1], 0, 0, 0, I[2][2])};
       })},
      {"M^-1 is missing", with([](const Body&) { return Mass{1, mat3(1)}; })},
      {"the inverse masses are missing",
       with([](const Body& body) { return Mass{1, inverse_inertia(body)}; })},
      {"the inverse inertia is missing",
       with([](const Body& body) { return Mass{body.inverse_mass, mat3(1)}; })},
      {"#body-2-alone body 1 is missing", scaled(0, 0, 1, 1)},
      {"#sum-that-thrown-away body 2 is missing", scaled(1, 1, 0, 0)},
      {"#without-turns the angular parts are missing: the blocks w1 and w2", scaled(1, 0, 1, 0)},
      {"the linear blocks v1 and v2 are missing", scaled(0, 1, 0, 1)},
      {"#minus-body-1 the sign of body 1's terms: the terms of both bodies are added",
       scaled(-1, -1, 1, 1)},
      {"the sign of body 2's terms: the terms of both bodies are added", scaled(1, 1, -1, -1)},
      {"the sign of the rotations' terms: all four terms are added", scaled(1, -1, 1, -1)},
      {"the sign of the result", scaled(-1, -1, -1, -1)},
      {"the row a with itself: one side belongs to b",
       [=](const Case& c) { return table.right({"", c.a, c.a, c.pair}); }},
      {"the row b with itself: one side belongs to a",
       [=](const Case& c) { return table.right({"", c.b, c.b, c.pair}); }},
      {"mass and inertia of the other body",
       of_bodies([=](const Body& one, const Body& two) {
         return std::pair(inverse_of(two), inverse_of(one));
       })},
      {"#inertia-other-body the inertia of the other body",
       of_bodies([](const Body& one, const Body& two) {
         return std::pair(Mass{one.inverse_mass, inverse_inertia(two)},
                          Mass{two.inverse_mass, inverse_inertia(one)});
       })},
      {"#inertia-body-1-both the inertia of body 1 for both bodies: each has its own",
       of_bodies([=](const Body& one, const Body& two) {
         return std::pair(inverse_of(one), Mass{two.inverse_mass, inverse_inertia(one)});
       })},
      {"the inertia of body 2 for both bodies: each has its own",
       of_bodies([=](const Body& one, const Body& two) {
         return std::pair(Mass{one.inverse_mass, inverse_inertia(two)}, inverse_of(two));
       })},
      {"the inverse mass of body 1 for both bodies: each has its own",
       of_bodies([=](const Body& one, const Body& two) {
         return std::pair(inverse_of(one), Mass{one.inverse_mass, inverse_inertia(two)});
       })},
      {"#mass-body-2-both the inverse mass of body 2 for both bodies: each has its own",
       of_bodies([=](const Body& one, const Body& two) {
         return std::pair(Mass{two.inverse_mass, inverse_inertia(one)}, inverse_of(two));
       })},
      {"mass and inertia of body 1 for both bodies: each has its own",
       of_bodies([=](const Body& one, const Body&) {
         return std::pair(inverse_of(one), inverse_of(one));
       })},
      {"mass and inertia of body 2 for both bodies: each has its own",
       of_bodies([=](const Body&, const Body& two) {
         return std::pair(inverse_of(two), inverse_of(two));
       })},
      {"#crossed-v1-v2 blocks of body 1 with those of body 2: v1 with v1, w1 with w1",
       [=](const Case& c) {
         const Row swapped{c.b.v2, c.b.w2, c.b.v1, c.b.w1};
         return product(c.a, inverse_of(c.pair.body1), inverse_of(c.pair.body2), swapped);
       }},
      {"#w1-for-w2 w1 where w2 belongs: body 2 takes its own blocks, a.w2 and b.w2",
       with_blocks([](Row& a, Row& b) { a.w2 = a.w1, b.w2 = b.w1; })},
      {"#a-copied-block a.w1 where a.w2 belongs", with_blocks([](Row& a, Row&) { a.w2 = a.w1; })},
      {"b.w1 where b.w2 belongs", with_blocks([](Row&, Row& b) { b.w2 = b.w1; })},
      {"v1 where v2 belongs: body 2 takes its own blocks, a.v2 and b.v2",
       with_blocks([](Row& a, Row& b) { a.v2 = a.v1, b.v2 = b.v1; })},
      {"a.v1 where a.v2 belongs", with_blocks([](Row& a, Row&) { a.v2 = a.v1; })},
      {"b.v1 where b.v2 belongs", with_blocks([](Row&, Row& b) { b.v2 = b.v1; })},
      {"one over the result: that is an effective mass",
       [=](const Case& c) { return Numbers{1 / table.right(c)[0]}; }},
      {"#zero-static-body a static body has an answer, too: its own term is 0, the other body's is "
       "not",
       [=](const Case& c) {
         const bool wall = c.pair.body1.is_static() || c.pair.body2.is_static();
         return wall ? Numbers{0} : table.right(c);
       }},
      {"a static body 1 has an answer, too: its own term is 0, body 2's is not",
       [=](const Case& c) { return c.pair.body1.is_static() ? Numbers{0} : table.right(c); }},
      {"#zero-static-body-2 a static body 2 has an answer, too: its own term is 0, body 1's is not",
       [=](const Case& c) { return c.pair.body2.is_static() ? Numbers{0} : table.right(c); }},
      {"#int-sum the sum is an int: it cuts the fraction off", [=](const Case& c) {
         int sum = 0;
         for (int k = 0; k < 4; ++k)
           sum += int(scaled(k == 0, k == 1, k == 2, k == 3)(c)[0] + sum) - sum;
         return Numbers{double(sum)};
       }},
      {"one term of body 1 and one of body 2: each body has two", scaled(1, 0, 0, 1)}};
  const char* const terms[] = {"the push of body 1", "the turn of body 1", "the push of body 2",
                               "the turn of body 2"};
  const char* const term_blocks[] = {": the blocks v1", ": the blocks w1", ": the blocks v2",
                                     ": the blocks w2"};
  for (int k = 0; k < 4; ++k) {
    const auto but = [&](real other, real own) {
      std::array<real, 4> f{other, other, other, other};
      f[std::size_t(k)] = own;
      return scaled(f[0], f[1], f[2], f[3]);
    };
    const std::string term = terms[k], of_blocks = term_blocks[k];
    vec3 Row::*const block = std::array{&Row::v1, &Row::w1, &Row::v2, &Row::w2}[std::size_t(k)];
    table.mistakes.push_back({"row a stands on both sides in " + term,
                              with_blocks([=](Row& a, Row& b) { b.*block = a.*block; })});
    table.mistakes.push_back({"row b stands on both sides in " + term,
                              with_blocks([=](Row& a, Row& b) { a.*block = b.*block; })});
    table.mistakes.push_back({term + " is missing" + of_blocks, but(1, 0)});
    table.mistakes.push_back({"the sign of " + term + of_blocks, but(1, -1)});
    table.mistakes.push_back({term + " is there twice" + of_blocks, but(1, 2)});
    table.mistakes.push_back({"only " + term + " is left" + of_blocks +
                                  ". Is an = there where += belongs?", but(0, 1)});
  }
  table.cases = rows_cases();
  table.tolerance = 10 * rounding;
  return table;
}

}  // namespace joints::testing
