// Exercise 6.3 as tables of cases with their usual mistakes: a position projection of a
// point and to a rope.
#pragma once

#include "tests/06_baumgarte/projection_moves.h"

namespace joints::testing {

inline bool near_one(real a) { return std::abs(double(a) - 1) <= rounding; }
inline constexpr const char* no_sum =
    "#quaternions-added a sum of quaternions is no orientation: take turned(q, w, 1), which "
    "normalises it";

template <class Part>
CaseTable<ProjectionCase<Part>> projection_table(const Subject& subject,
                                       std::vector<ProjectionCase<Part>> cases) {
  using Case = ProjectionCase<Part>;
  using Reference = ProjectionReference<Part>;
  constexpr int n = Part::rows;
  using Rules = ProjectionRules<Part>;
  const auto of = [](const Moves& a, const Moves& b = {}) { return Rules::of(a, b); };
  const auto changed = [](auto change) { return Rules::changed(change); };
  const auto velocities = [](auto poses, auto change) { return Rules::velocities(poses, change); };
  const auto the_moves = [](const Moves& a, const Moves&) { return a; };
  const auto no_moves = [](const Moves&, const Moves&) { return Moves{}; };
  const auto pushed = [=](auto lambda) {
    return changed([=](const Reference& reference, const Moves&) {
      return response<n>(reference.J, lambda(reference), reference.pair);
    });
  };
  const auto times = [=](double factor) {
    return changed([=](const Reference&, const Moves& a) {
      return scaled(real(factor), real(factor), a);
    });
  };
  const auto turns = [=](auto other) {  // of a body with its turn: what happens instead
    return changed([=](const Reference& reference, Moves a) {
      a.turn1 = other(reference.pair.body1, a.turn1);
      a.turn2 = other(reference.pair.body2, a.turn2);
      return a;
    });
  };
  const auto right = changed([](const Reference&, const Moves& a) { return a; });
  const auto yours = [=](const Case& c) {
    Pair after = c.pair;
    project(c.part, after.body1, after.body2);
    const Body &a = c.pair.body1, &b = c.pair.body2;
    return of(between(c.pair, after),
              {after.body1.v - a.v, after.body1.w - a.w, after.body2.v - b.v,
               after.body2.w - b.w});
  };
  double factor = 0;  // by which the moves of the first case are too long, whatever it is
  {
    const Numbers mine = yours(cases[0]), other = right(cases[0]);
    double size = 0;
    for (std::size_t i = 0; i < mine.size(); ++i) {
      factor += mine[i] * other[i];
      size += other[i] * other[i];
    }
    factor /= size;
  }
  const bool moves = std::any_of(cases.begin(), cases.end(), [&](const Case& c) {
    return close(yours(c), right(c), difference_tolerance) &&
           !close(yours(c), of({}), difference_tolerance);
  });

  const bool normal = std::all_of(cases.begin(), cases.end(), [](const Case& c) {
    Pair after = c.pair;
    project(c.part, after.body1, after.body2);
    return near_one(length(after.body1.q)) && near_one(length(after.body2.q));
  });

  CaseTable<Case> table{subject,
                        {"move of 1", "rotation of 1", "move of 2", "rotation of 2", "change of v1",
                         "change of w1", "change of v2", "change of w2"},
                        yours, right, {}, cases};
  table.tolerance = difference_tolerance;
  auto& add = table.mistakes;
  add = {{moves ? "no body moves in this case, but in others: every gap is closed, large or small, "
                  "beside a static body, too"
                : "#brought-rest-after-push nothing moves: nothing is done yet, or the copies "
                  "move and not the bodies themselves, or the copies are brought to rest after "
                  "the push: before it. Or an int cuts lambda to 0",
          times(0)},
         {Part::one_sided ? "the sign: lambda = -C/K works against the error of the rope (that of "
                            "its rod has the other sign)"
                          : "the sign: lambda = -K^-1 C works against the gap", times(-1)},
         {"#times-h times h: there is no step in it. lambda is an impulse times a time already",
          times(1.0 / 60)},
         {"divided by h: there is no step in it, K lambda = -C", times(60)}};
  if (factor > 0 && factor < 1 - 100 * difference_tolerance)
    add.push_back({"#share-gap only a fraction of the gap is removed: a projection has no beta, it "
                   "removes all of it",
                   times(factor)});
  if (factor > 1 + 100 * difference_tolerance)
    add.push_back({"more than the gap is removed, " + short_number(factor) +
                       " times: a projection removes it once", times(factor)});
  add.insert(
      add.end(),
      {{"#velocities-changed the velocities are changed, and the poses stay: add the moves to x "
        "and turn q by them",
        velocities(no_moves, the_moves)},
       {"the velocities are changed, too: they stay as they are, take copies of the bodies",
        velocities(the_moves, the_moves)},
       {"the bodies' own velocities are pushed and added: push copies with zero velocity",
        velocities(sum, the_moves)},
       {"the velocities are lost: only those of the copies are zero, the bodies keep theirs",
        velocities(the_moves, [](const Moves&, const Moves& b) { return scaled(-1, -1, b); })},
       {"the velocities hold the moves now: they stay as they are. Are those of the copies "
        "written back, too? Only x and q move",
        velocities(the_moves,
                   [](const Moves& a, const Moves& b) { return sum(a, scaled(-1, -1, b)); })},
       {"the velocities are in lambda: K lambda = -C has no J V",
        pushed([](const Reference& reference) { return reference.with_velocities(); })},
       {"#k-missing-lambda-k K is missing: lambda is -K^-1 C",
        pushed([](const Reference& reference) { return reference.without_K(); })},
       {"times K where its inverse belongs", pushed([](const Reference& reference) {
          return Reference::times(reference.K, reference.C);
        })},
       {"K without the rotations: it holds the masses only", pushed([](const Reference& reference) {
          return Reference::solved(product_K(reference.J, reference.pair.body1.inverse_mass,
                                             mat3(0), reference.pair.body2.inverse_mass, mat3(0)),
                                   reference.C);
        })},
       {"the rotations are missing: the other half of Eq. 6-11",
        turns([](const Body&, const vec3&) { return vec3(0); })},
       {"a body turns in its own axes: exp(w) q and not q exp(w), w is in world axes",
        turns([](const Body& body, const vec3& turn) { return body.q * turn; })},
       {"the sign of the rotations", turns([](const Body&, const vec3& turn) { return -turn; })},
       {normal ? "half the rotation: turned(q, w, 1) halves the angle itself" : no_sum,
        turns([](const Body&, const vec3& turn) { return turn / real(2); })},
       {"twice the rotation: turned(q, w, 1) halves the angle itself",
        turns([](const Body&, const vec3& turn) { return real(2) * turn; })},
       {"the rotation is multiplied by h: turned(q, w, 1), for w is an angle already",
        turns([](const Body&, const vec3& turn) { return turn / real(60); })},
       {normal ? "#first-order-turn q + (0, w) q/2 is only the first term of it: take turned(q, "
                 "w, 1)" : no_sum,
        turns([](const Body&, const vec3& turn) {
          const real half = length(turn) / 2;
          return half > 0 ? std::atan(half) / half * turn : turn;
        })},
       {"body-space inertia: take inverse_inertia(body)",
        turns([](const Body& body, const vec3& turn) {
          return body.is_static()
                     ? vec3(0)
                     : body.inverse_inertia_local * (inverse(inverse_inertia(body)) * turn);
        })},
       {"the moves are missing: the first half of Eq. 6-11",
        changed([](const Reference&, const Moves& a) {
          return Moves{vec3(0), a.turn1, vec3(0), a.turn2};
        })},
       {"#only-body-2 only body 2 moves: both bodies move",
        changed([](const Reference&, const Moves& a) { return scaled(0, 1, a); })},
       {"only body 1 moves: both bodies move",
        changed([](const Reference&, const Moves& a) { return scaled(1, 0, a); })},
       {"the moves of the two bodies are exchanged", changed([](const Reference&, const Moves& a) {
          return Moves{a.way2, a.turn2, a.way1, a.turn1};
        })},
       {"the moves of the two bodies are exchanged, their rotations are not",
        changed([](const Reference&, const Moves& a) {
          return Moves{a.way2, a.turn1, a.way1, a.turn2};
        })},
       {"the rotations of the two bodies are exchanged, their moves are not",
        changed([](const Reference&, const Moves& a) {
          return Moves{a.way1, a.turn2, a.way2, a.turn1};
        })},
       {"#sign-moves the sign of the moves: they are added to x, lambda has the sign already",
        changed([](const Reference&, const Moves& a) {
          return Moves{-a.way1, a.turn1, -a.way2, a.turn2};
        })},
       {"both moves are added to body 1: body 2 has its own",
        changed([](const Reference&, const Moves& a) {
          return Moves{a.way1 + a.way2, a.turn1, vec3(0), a.turn2};
        })},
       {"both moves are added to body 2: body 1 has its own",
        changed([](const Reference&, const Moves& a) {
          return Moves{vec3(0), a.turn1, a.way1 + a.way2, a.turn2};
        })},
       {"body 2 is turned from where body 1 stands: its own q, turned",
        changed([](const Reference& reference, Moves a) {
          const quat q1 = rotation(a.turn1) * reference.pair.body1.q;
          a.turn2 = turn_between(reference.pair.body2.q, rotation(a.turn2) * q1);
          return a;
        })},
       {"this is two projections: one closes the gap to first order, the next does the rest",
        [=](const Case& c) {
          Pair at = c.pair;
          for (int n = 0; n < 2; ++n) move_by(reference_moves(c.part, at), at.body1, at.body2);
          return of(between(c.pair, at));
        }},
       {"the inverse masses are missing", changed([](const Reference& reference, Moves a) {
          const auto push = [&](const Body& body, const vec3& way) {
            return body.is_static() ? way : way / body.inverse_mass;
          };
          a.way1 = push(reference.pair.body1, a.way1);
          a.way2 = push(reference.pair.body2, a.way2);
          return a;
        })}});
  if (n > 1)
    add.push_back({"#each-row-own-k each row divided by its own K: the rows of a block are solved "
                   "together",
                   pushed([](const Reference& reference) { return reference.each_row_alone(); })});
  for (const int share : {0, 1, 2, 3})  // of body 1: none, half, all, by the inverse masses
    add.push_back({"#shared-by-masses the gap itself is divided between the bodies: they move and "
                   "rotate by M^-1 J^T lambda, Eq. 6-11",
                   changed([=](const Reference& reference, const Moves&) {
                     const real m1 = reference.pair.body1.inverse_mass;
                     const real m2 = reference.pair.body2.inverse_mass;
                     const real of_1 = share < 3 ? real(share) / 2 : m1 / (m1 + m2);
                     Moves out;
                     for (int i = 0; i < n; ++i) {
                       out.way1 -= of_1 * reference.C[std::size_t(i)] * reference.J[i].v1;
                       out.way2 -= (1 - of_1) * reference.C[std::size_t(i)] * reference.J[i].v2;
                     }
                     return out;
                   })});
  if constexpr (n == 3)
    add.push_back({"#k-along-gap K along the gap only: the block is solved as a whole, lambda = "
                   "-K^-1 C",
                   pushed([](const Reference& reference) {
                     real CC = 0, CKC = 0;
                     for (int i = 0; i < 3; ++i)
                       for (int j = 0; j < 3; ++j) {
                         CC +=
                             i == j ? reference.C[std::size_t(i)] * reference.C[std::size_t(i)] : 0;
                         CKC += reference.C[std::size_t(i)] * reference.K[i][j] *
                                reference.C[std::size_t(j)];
                       }
                     Vector<3> out = reference.without_K();
                     for (real& a : out) a *= CC / CKC;
                     return out;
                   })});
  for (const bool all : {false, true})
    for (const bool place : {false, true})
      add.push_back({place ? "the place of an anchor is no lever: that begins at the centre, "
                             "to_world(body, anchor)"
                           : "#body-space-arms body-space lever: the levers are not turned into "
                             "the world",
                     [=](const Case& c) {
                       Reference reference(c.part, c.pair);
                       if (Part::one_sided && reference.C[0] >= 0) return of({});
                       const auto& rod = rod_of(c.part);
                       const auto lever = [=](const Body& body, const vec3& anchor) {
                         return place ? world_point(body, anchor) : anchor;
                       };
                       reference.J = reference.levers(lever(c.pair.body1, rod.anchor1_local),
                                            lever(c.pair.body2, rod.anchor2_local));
                       if (all) reference.K = dense_K(reference.J, c.pair.body1, c.pair.body2);
                       return of(reference.moves());
                     }});
  add_single_moves<Part>(add);
  add_copies<Part>(add);
  if constexpr (Part::one_sided) {
    add_rope<Part>(add);
    read_off(table, [=] { return threshold_of(table); });
  }
  return table;
}

}  // namespace joints::testing
