// Exercise 6.3: mistakes with single moves of a position projection, with the copies that
// are given lambda, and with a rope's question.
#pragma once

#include "tests/06_baumgarte/projection_reference.h"

namespace joints::testing {

/// How the answer to a projection is written down, and the effect of a mistake on it.
template <class Part>
struct ProjectionRules {
  using Case = ProjectionCase<Part>;
  using Reference = ProjectionReference<Part>;
  using Mistakes = typename CaseTable<Case>::Mistakes;

  static Numbers of(const Moves& poses, const Moves& velocities = {}) {
    const auto short_way = [](const vec3& a) { return turn_between({1, 0, 0, 0}, rotation(a)); };
    return flat({poses.way1, short_way(poses.turn1), poses.way2, short_way(poses.turn2),
                 velocities.way1, velocities.turn1, velocities.way2, velocities.turn2});
  }
  /// What a mistake does to the moves, or to lambda, where there is something to do.
  template <class Change>
  static auto changed(Change change) {
    return [=](const Case& c) {
      const Reference reference(c.part, c.pair);
      return Part::one_sided && reference.C[0] >= 0 ? of({})
                                                    : of(change(reference, reference.moves()));
    };
  }
  /// What a mistake does to the velocities: of the moves and the velocities before.
  template <class Poses, class Change>
  static auto velocities(Poses poses, Change change) {
    return [=](const Case& c) {
      const Reference reference(c.part, c.pair);
      if (Part::one_sided && reference.C[0] >= 0) return of({});
      const Moves a = reference.moves(), b = velocities_of(c.pair);
      return of(poses(a, b), change(a, b));
    };
  }
};

/// Each of the four moves alone.
template <class Part>
void add_single_moves(typename ProjectionRules<Part>::Mistakes& add) {
  using Rules = ProjectionRules<Part>;
  using Reference = typename Rules::Reference;
  const auto changed = [](auto change) { return Rules::changed(change); };
  for (int k = 0; k < 4; ++k) {  // each of the four moves alone
    const auto& [move, words] = four_moves[k];
    const auto one = [=, move = move](auto instead) {
      return changed([=](const Reference& reference, Moves a) {
        a.*move = instead(reference.pair, a);
        return a;
      });
    };
    const auto other = four_moves[(k + 2) % 4].of;
    add.push_back({words + " is missing", one([](const Pair&, const Moves&) { return vec3(0); })});
    add.push_back({"the sign of " + words, one([=, move = move](const Pair&, const Moves& a) {
                     return -(a.*move);
                   })});
    add.push_back({words + " is that of the other body",
                   one([=](const Pair&, const Moves& a) { return a.*other; })});
    add.push_back({words + " gets that of the other body, too",
                   one([=, move = move](const Pair&, const Moves& a) {
                     return a.*move + a.*other;
                   })});
    if (k % 2 == 1)
      add.push_back({words + " is in its own axes: exp(w) q and not q exp(w)",
                     one([=, move = move](const Pair& pair, const Moves& a) {
                       return (k == 1 ? pair.body1 : pair.body2).q * (a.*move);
                     })});
  }
  // a new value where the move belongs beside the old one
  const auto replaced = [=](bool first, bool second, bool places) {
    return changed([=](const Reference& reference, Moves a) {
      const auto turn = [](const Body& body, const vec3& move) {
        return turn_between(body.q, rotation(move));
      };
      if (first && places) a.way1 -= reference.pair.body1.x;
      if (second && places) a.way2 -= reference.pair.body2.x;
      if (first && !places) a.turn1 = turn(reference.pair.body1, a.turn1);
      if (second && !places) a.turn2 = turn(reference.pair.body2, a.turn2);
      return a;
    });
  };
  for (const int which : {3, 1, 2}) {
    const std::string who = which == 3 ? "both bodies" : "body " + std::to_string(which);
    add.push_back({"the place of " + who + " is replaced by the move: += and not =",
                   replaced(which & 1, which & 2, true)});
    add.push_back({"the orientation of " + who + " is replaced by the rotation: turned(q, w, 1) "
                   "rotates the old one", replaced(which & 1, which & 2, false)});
    add.push_back({"the move of " + who + " is added to its v, not to its x",
                   Rules::velocities(
                       [=](Moves a, const Moves&) {
                         if (which & 1) a.way1 = vec3(0);
                         if (which & 2) a.way2 = vec3(0);
                         return a;
                       },
                       [=](const Moves& a, const Moves&) {
                         return Moves{real(which & 1) * a.way1, vec3(0),
                                      real(which >> 1 & 1) * a.way2, vec3(0)};
                       })});
  }
  const char* const only_v[] = {"v of both bodies", "v of body 1", "v of body 2",
                                "w of both bodies", "w of body 1", "w of body 2"};
  for (int k = 0; k < 6; ++k)
    add.push_back({std::string(only_v[k]) + " is lost: the velocities stay as they are",
                   Rules::velocities([](const Moves& a, const Moves&) { return a; },
                                     [=](const Moves&, const Moves& b) {
                                       const bool first = k % 3 != 2, second = k % 3 != 1;
                                       Moves out;
                                       (k < 3 ? out.way1 : out.turn1) =
                                           -real(first) * (k < 3 ? b.way1 : b.turn1);
                                       (k < 3 ? out.way2 : out.turn2) =
                                           -real(second) * (k < 3 ? b.way2 : b.turn2);
                                       return out;
                                     })});
}

/// The copies that are given lambda, and the bodies that error, K and J are asked of.
template <class Part>
void add_copies(typename ProjectionRules<Part>::Mistakes& add) {
  using Rules = ProjectionRules<Part>;
  using Reference = typename Rules::Reference;
  const auto changed = [](auto change) { return Rules::changed(change); };
  for (int flying = 15; flying > 0; --flying)  // which of the four velocities of the copies
    add.push_back({"#copies-not-rest v and w of both copies must be zero before they are given "
                   "lambda",
                   changed([=](const Reference& reference, Moves a) {
                     const Moves b = velocities_of(reference.pair);
                     for (int k = 0; k < 4; ++k)
                       if (flying >> k & 1) a.*four_moves[k].of += b.*four_moves[k].of;
                     return a;
                   })});
  for (int which = 1; which < 8; ++which) {
    add.push_back({"the bodies are exchanged in " + Reference::words(which) + ": body 1 first",
                   changed([=](const Reference& reference, const Moves&) {
                     const Pair& pair = reference.pair;
                     const Reference back(reference.part, {pair.body2, pair.body1});
                     return reference.with(back, which).moves();
                   })});
    if (Reference::n == 3 && which > 3)
      continue;  // what J of a point has of body 2 is the same then
    add.push_back({"taken again after body 1 has moved (" + Reference::words(which) +
                       "): one lambda, "
                       "from the poses before the projection, moves both",
                   changed([=](const Reference& reference, Moves a) {
                     Pair at = reference.pair;
                     move_by({a.way1, a.turn1, vec3(0), vec3(0)}, at.body1, at.body2);
                     const Moves late =
                         reference.with(Reference(reference.part, at), which).moves();
                     return Moves{a.way1, a.turn1, late.way2, late.turn2};
                   })});
  }
  // J^T lambda on other copies
  const auto given_to = [=](auto one, auto two, bool exchanged) {
    return changed([=](const Reference& reference, const Moves&) {
      Jacobian<Reference::n> J = reference.J;
      if (exchanged)
        for (Row& row : J.row) row = {row.v2, row.w2, row.v1, row.w1};
      return response<Reference::n>(J, reference.lambda(),
                                    {reference.pair.*one, reference.pair.*two});
    });
  };
  add.push_back({"#copies-exchanged the copies are exchanged in apply_impulse: the one of body 1 "
                 "comes first",
                 given_to(&Pair::body1, &Pair::body2, true)});
  add.push_back({"#copies-body-1 both copies are copies of body 1: each body has its own",
                 given_to(&Pair::body1, &Pair::body1, false)});
  add.push_back({"both copies are copies of body 2: each body has its own",
                 given_to(&Pair::body2, &Pair::body2, false)});
  if constexpr (Reference::n == 3)
    for (int k = 0; k < 3; ++k)
      add.push_back({std::string("only C.") + "xyz"[k] + " counts: the gap has three numbers",
                     changed([=](Reference reference, const Moves&) {
                       for (int i = 0; i < 3; ++i)
                         if (i != k) reference.C[std::size_t(i)] = 0;
                       return reference.moves();
                     })});
}

/// The test of a rope, and its wrong replacements.
template <class Part>
void add_rope(typename ProjectionRules<Part>::Mistakes& add) {
  using Rules = ProjectionRules<Part>;
  using Case = typename Rules::Case;
  using Reference = typename Rules::Reference;
  const auto of = [](const Moves& a) { return Rules::of(a); };
  const auto whatever = [=](auto live, int sign = 1) {
    return [=](const Case& c) {
      const Reference reference(c.part, c.pair);
      return live(reference.C[0]) ? of(scaled(real(sign), real(sign), reference.moves())) : of({});
    };
  };
  const auto as_point = [=](auto live) {
    return [=](const Case& c) {
      const Reference reference(c.part, c.pair);
      const Point point{c.part.rod.anchor1_local, c.part.rod.anchor2_local};
      return live(reference.C[0]) ? of(reference_moves(point, c.pair)) : of({});
    };
  };
  const auto always = [](real) { return true; };
  const auto too_long = [](real C) { return C < 0; };
  const auto slack = [](real C) { return C > 0; };
  const char* const no_point = "#as-a-point this is the projection of a point, which draws the "
                               "two anchors into one: a rope is drawn to its length, by its own "
                               "row";
  const char* const rod = "the error of the rod has the other sign: rope.error is negative "
                          "where the rope is too long";
  add.insert(add.begin(),
             {{"#slack-is-pushed a slack rope is pushed to its length: it is left alone where C "
               ">= 0",
               whatever(always)},
              {"#wrong-way-round the wrong way round: C < 0 is too long, C > 0 is slack. (The "
               "error of its rod has the other sign)", whatever(slack)},
              {rod, whatever(slack, -1)},
              {rod, whatever(always, -1)},
              {no_point, as_point(too_long)},
              {no_point, as_point(always)}});
}

/// From which error on a rope moves, where that is the only thing that is wrong; "" elsewhere.
template <class Part>
std::string threshold_of(const CaseTable<ProjectionCase<Part>>& table) {
  real moves = -unbounded, rests = unbounded;  // the greatest C that moves, the least that rests
  for (const ProjectionCase<Part>& c : table.cases) {
    const ProjectionReference<Part> reference(c.part, c.pair);
    const Numbers yours = table.yours(c);
    if (close(yours, ProjectionRules<Part>::of({}), table.tolerance))
      rests = std::min(rests, reference.C[0]);
    else if (close(yours, ProjectionRules<Part>::of(reference.moves()), table.tolerance))
      moves = std::max(moves, reference.C[0]);
    else return "";
  }
  if (moves > rests || (moves < 0 && rests > 0) || std::isinf(moves) || std::isinf(rests))
    return "";
  return moves < 0 ? "a rope that is hardly too long is left alone: there is no threshold, C < 0 "
                     "is too long"
                   : "a rope that is hardly slack is pushed to its length: there is no threshold, "
                     "C >= 0 is left alone";
}

}  // namespace joints::testing
