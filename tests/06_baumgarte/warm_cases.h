// Exercise 6.2, the warm start, as a table of cases with its usual mistakes.
#pragma once

#include <algorithm>

#include "chapters/06_baumgarte/baumgarte.h"
#include "tests/checker/fixtures.h"
#include "tests/checker/impulse_lines.h"
#include "tests/checker/vector_cases.h"

namespace joints::testing {

// ---- what an impulse does -----------------------------------------------------------------------

/// M^-1 J^T lambda: what an impulse does to velocities, or Eq. 6-11 to poses.
struct Moves {
  vec3 way1{0}, turn1{0}, way2{0}, turn2{0};
};
template <int N>
Moves response(const Jacobian<N>& J, const Vector<N>& lambda, const Pair& pair) {
  const FourVectors a = ImpulseLines(pair).changes(impulses<N>(J, lambda));
  return {a[0], a[1], a[2], a[3]};
}
inline Moves scaled(real one, real two, const Moves& a) {
  return {one * a.way1, one * a.turn1, two * a.way2, two * a.turn2};
}

// ---- 6.2 the warm start -------------------------------------------------------------------------

struct WarmCase {
  std::string words;
  Jacobian<3> J;
  double ratio;
  vec3 lambda;
  Pair pair;
};

/// The rows of a ball joint between two turned bodies that fly and spin.
inline WarmCase warm_case(const std::string& words, double ratio, unsigned seed) {
  Random random(seed);
  Pair pair = uneven_pair();
  move_together(pair, random);
  for (Body* body : {&pair.body1, &pair.body2}) {
    body->v = random.vector(2);
    body->w = random.vector(2);
  }
  const Point part = point_at(pair.body1, pair.body2, pair.body1.x + random.vector(1));
  return {words, numeric_jacobian(part, pair.body1, pair.body2), ratio, random.vector(2), pair};
}

/// The path to the answer: what is applied, by which rows, in which four lines; what is kept.
struct WarmReference {
  Jacobian<3> J;
  vec3 applied, kept;
  ImpulseLines lines;
  real ratio;
  explicit WarmReference(const WarmCase& c)
      : J(c.J), applied(real(c.ratio) * c.lambda), kept(applied), lines(c.pair),
        ratio(real(c.ratio)) {}
  Numbers answer() const {
    const FourVectors a = lines.changes(impulses<3>(J, to_vector(applied)));
    return flat({kept, a[0], a[1], a[2], a[3]});
  }
};
inline Pieces<WarmReference> wrong_warm_starts() {
  using T = WarmReference;
  const auto lambda = [](auto of) {
    return Call<void(T&)>([=](T& t) {
      const vec3 before = t.applied / t.ratio;
      t.applied = t.kept = of(before, t.ratio);
    });
  };
  Pieces<T> out = {
      {"the ratio is rounded: it is a real, and half a step is 0.5",
       lambda([](const vec3& a, real r) { return std::round(r) * a; })},
      {"#one-minus-ratio 1 - ratio: the impulse of this step is the ratio times the last one",
       lambda([](const vec3& a, real r) { return (1 - r) * a; })},
      {"#kept-below-one the ratio is kept below 1: a longer step needs more",
       lambda([](const vec3& a, real r) { return std::min(r, real(1)) * a; })},
      {"the ratio is kept above 1: a shorter step needs less",
       lambda([](const vec3& a, real r) { return std::max(r, real(1)) * a; })},
      {"#added-to-lambda the ratio is added to lambda: it is a factor",
       lambda([](const vec3& a, real r) { return a + vec3(r); })},
      {"lambda is made a unit vector first: it keeps its length",
       lambda([](const vec3& a, real r) { return r * direction(a); })},
      {"#nothing-last-step-kept lambda begins at zero where the step has changed: it is scaled by "
       "the ratio",
       lambda([](const vec3& a, real r) { return r == 1 ? a : vec3(0); })},
      {"only the first two rows are applied: there are three", [](T& t) { t.applied.z = 0; }},
      {"only the last two rows are applied: there are three", [](T& t) { t.applied.x = 0; }},
      {"#rows-take-each-other each row takes the place of the one before: += and not =", [](T& t) {
         t.applied.x = t.applied.y = 0;
         t.lines.set.fill(true);
       }},
      {"J[0] is taken for every row", [](T& t) { t.J[1] = t.J[2] = t.J[0]; }}};
  for (int k = 0; k < 3; ++k)
    out.push_back({std::string("only lambda.") + "xyz"[k] + " is scaled: all three are", [=](T& t) {
                     for (int i = 0; i < 3; ++i)
                       if (i != k) t.applied[i] /= t.ratio, t.kept[i] /= t.ratio;
                   }});
  for (const auto& piece : wrong_lines(&T::lines)) out.push_back(piece);
  return out;
}

inline CaseTable<WarmCase> warm_table() {
  using Case = WarmCase;
  const auto of = [](const vec3& lambda, const Moves& a) {
    return flat({lambda, a.way1, a.turn1, a.way2, a.turn2});
  };
  const auto moves = [](const Case& c) { return response<3>(c.J, to_vector(c.lambda), c.pair); };
  // the kept part of lambda, and the parts given to body 1 and body 2, by the ratio
  const auto shares = [=](auto share) {
    return [=](const Case& c) {
      const std::array<double, 3> a = share(c.ratio);
      return of(real(a[0]) * c.lambda, scaled(real(a[1]), real(a[2]), moves(c)));
    };
  };
  using A = std::array<double, 3>;
  CaseTable<Case> table{{"6.2", "the warm start"},
                        {"lambda kept", "change of v1", "change of w1", "change of v2",
                         "change of w2"}, {}, {}, {}, {}};
  table.yours = [=](const Case& c) {
    vec3 lambda = c.lambda;
    Pair after = c.pair;
    warm_start(c.J, real(c.ratio), lambda, after.body1, after.body2);
    return of(lambda, {after.body1.v - c.pair.body1.v, after.body1.w - c.pair.body1.w,
                       after.body2.v - c.pair.body2.v, after.body2.w - c.pair.body2.w});
  };
  table.right = shares([](double r) { return A{r, r, r}; });
  table.mistakes = {
      {"nothing is applied where the step has not changed: lambda acts on the bodies in every step",
       shares([](double r) {
         return r == 1 ? A{1, 0, 0} : A{r, r, r};
       })},
      {"#ratio-int the ratio is cut to a whole number: it is a real, and half a step is 0.5",
       shares([](double r) {
         return A{std::floor(r), std::floor(r), std::floor(r)};
       })},
      {"only v changes: lambda rotates the bodies, too, so w changes",
       [=](const Case& c) {
         Moves a = scaled(real(c.ratio), real(c.ratio), moves(c));
         a.turn1 = a.turn2 = vec3(0);
         return of(real(c.ratio) * c.lambda, a);
       }},
      {"only w changes: lambda pushes the bodies, too, so v changes",
       [=](const Case& c) {
         Moves a = scaled(real(c.ratio), real(c.ratio), moves(c));
         a.way1 = a.way2 = vec3(0);
         return of(real(c.ratio) * c.lambda, a);
       }},
      {"the ratio is forgotten: half a step needs half the impulse", shares([](double) {
         return A{1, 1, 1};
       })},
      {"#divided-ratio divided by the ratio: half a step needs half the impulse",
       shares([](double r) {
         return A{1 / r, 1 / r, 1 / r};
       })},
      {"lambda is set to zero: it must hold what has been applied, for the iterations go on from "
       "there",
       shares([](double r) {
         return A{0, r, r};
       })},
      {"lambda is set to zero, and the ratio is forgotten", shares([](double) {
         return A{0, 1, 1};
       })},
      {"the old impulse is applied and the scaled one is kept: scale first, then apply",
       shares([](double r) {
         return A{r, 1, 1};
       })},
      {"#scaled-only-where-applied the scaled impulse is applied and the old one is kept: lambda "
       "must hold what was applied",
       shares([](double r) {
         return A{1, r, r};
       })},
      {"the impulse is applied twice: the iterations begin where it has been applied once",
       shares([](double r) {
         return A{r, 2 * r, 2 * r};
       })},
      {"the ratio is taken twice for the applied impulse", shares([](double r) {
         return A{r, r * r, r * r};
       })},
      {"the ratio is taken twice", shares([](double r) {
         return A{r * r, r * r, r * r};
       })},
      {"it acts on body 2 only: body 1 gets the opposite impulse, with its own lever",
       shares([](double r) {
         return A{r, 0, r};
       })},
      {"it acts on body 1 only: +lambda acts on body 2", shares([](double r) {
         return A{r, r, 0};
       })},
      {"the sign of the applied impulse: +M^-1 J^T lambda, as in "
       "apply_impulse", shares([](double r) {
         return A{r, -r, -r};
       })},
      {"the sign: the impulse of this step has the sign of the last one", shares([](double r) {
         return A{-r, -r, -r};
       })},
      {"#only-scaled nothing is applied: lambda is scaled, but does not act on the bodies",
       shares([](double r) {
         return A{r, 0, 0};
       })},
      {"nothing is done yet, or copies are changed: lambda is a reference, and so are the bodies",
       shares([](double) {
         return A{1, 0, 0};
       })},
      {"added to the old impulse where it takes its place: = and not +=", shares([](double r) {
         return A{1 + r, r, r};
       })},
      {"added to the old impulse where it takes its place: = and not +=", shares([](double r) {
         return A{1 + r, 1 + r, 1 + r};
       })},
      {"the bodies are exchanged: body 1 first, then body 2", [=](const Case& c) {
         const Moves a = response<3>(c.J, to_vector(real(c.ratio) * c.lambda),
                                     {c.pair.body2, c.pair.body1});
         return of(real(c.ratio) * c.lambda, {a.way2, a.turn2, a.way1, a.turn1});
       }}};
  table.cases = {warm_case("shorter step", 0.5, 621), warm_case("equal steps", 1, 622),
                 warm_case("longer step", 1.5, 623), warm_case("1 static", 0.8, 624)};
  Body& wall = table.cases.back().pair.body1;
  wall = static_body(wall.x, wall.q);
  table.tolerance = 10 * rounding;
  table.mistakes.push_back({"#nothing-beside-static-body beside a static body nothing is done: the "
                            "impulse acts on the other one",
                            [=, right = table.right](const Case& c) {
                              return c.pair.body1.is_static() || c.pair.body2.is_static()
                                         ? of(c.lambda, {}) : right(c);
                            }});
  table.mistakes.push_back({"beside a static body lambda is scaled and not applied: it acts on the "
                            "other one", [=, right = table.right](const Case& c) {
                              return c.pair.body1.is_static() || c.pair.body2.is_static()
                                         ? of(real(c.ratio) * c.lambda, {}) : right(c);
                            }});
  add_pieces(table, [](const Case& c) { return WarmReference(c); },
             [](const WarmReference& t) { return t.answer(); }, wrong_warm_starts());
  return table;
}

}  // namespace joints::testing
