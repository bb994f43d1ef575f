// Exercise 7.3: the colours that are right, and those that the usual mistakes give.
#pragma once

#include <algorithm>
#include <functional>
#include <numeric>

#include "tests/07_performance/colour_scenes.h"

namespace joints::testing {

// ---- right and wrong ----------------------------------------------------------------------------

/// A body that moves and that both joints hold.
inline bool share_a_body(const ColourScene& scene, const BodyPair& a, const BodyPair& b) {
  const auto both = [&](int body) {
    return scene.moves[std::size_t(body)] && (body == b.body1 || body == b.body2);
  };
  return both(a.body1) || both(a.body2);
}

/// First fit, asked of every joint before: what `in_the_way(a, b)` says of an earlier one.
template <class InTheWay>
Colours first_fit(const ColourScene& scene, InTheWay in_the_way, int first = 0) {
  Colours out;
  for (std::size_t k = 0; k < scene.links.size(); ++k) {
    int colour = first;
    const auto free = [&] {
      for (std::size_t before = 0; before < k; ++before)
        if (out[before] == colour && in_the_way(scene.links[k], scene.links[before])) return false;
      return true;
    };
    while (!free()) ++colour;
    out.push_back(colour);
  }
  return out;
}
inline Colours right_colours(const ColourScene& scene) {
  return first_fit(
      scene, [&](const BodyPair& a, const BodyPair& b) { return share_a_body(scene, a, b); });
}

/// Each joint's colour from a number per body, which every joint changes.
template <class Rule>
Colours counted(const ColourScene& scene, Rule rule) {
  std::vector<int> of(scene.moves.size(), 0);
  Colours out;
  for (const BodyPair& link : scene.links) {
    int &one = of[std::size_t(link.body1)], &two = of[std::size_t(link.body2)];
    out.push_back(rule(one, two, scene.moves[std::size_t(link.body1)],
                       scene.moves[std::size_t(link.body2)]));
  }
  return out;
}

/// Each joint's colour from the colours at its bodies so far. \param choose the colour, of
/// `has(body, colour)` and the link \param keep is it kept for a body of the link?
template <class Choose, class Keep>
Colours chosen(const ColourScene& scene, Choose choose, Keep keep) {
  std::vector<Colours> taken(scene.moves.size());
  Colours out;
  for (const BodyPair& link : scene.links) {
    const auto has = [&](int body, int colour) {
      const Colours& of = taken[std::size_t(body)];
      return scene.moves[std::size_t(body)] &&
             std::find(of.begin(), of.end(), colour) != of.end();
    };
    out.push_back(choose(has, link));
    for (const int body : {link.body1, link.body2})
      if (keep(link, body)) taken[std::size_t(body)].push_back(out.back());
  }
  return out;
}

struct ColourMistake {
  const char* words;
  Call<Colours(const ColourScene&)> of;
};
inline std::vector<ColourMistake> colour_mistakes() {
  using Scene = ColourScene;
  const auto fit = [](auto in_the_way, int first = 0) {
    return [=](const Scene& scene) {
      const auto moves = [&](int body) { return bool(scene.moves[std::size_t(body)]); };
      return first_fit(
          scene,
          [&](const BodyPair& a, const BodyPair& b) { return in_the_way(moves, a, b); }, first);
    };
  };
  const auto named = [](int body, const BodyPair& b) { return body == b.body1 || body == b.body2; };
  const auto always_kept = [](auto choose) {
    return [=](const Scene& scene) {
      return chosen(scene, choose, [](const BodyPair&, int) { return true; });
    };
  };
  // what becomes of the colour at each joint before that shares a body with this one
  const auto neighbours = [](auto next) {
    return [=](const Scene& scene) {
      Colours out;
      for (std::size_t k = 0; k < scene.links.size(); ++k) {
        int colour = 0;
        for (std::size_t n = 0; n < k; ++n)
          if (share_a_body(scene, scene.links[k], scene.links[n]))
            colour = next(colour, out[n], n + 1 == k);
        out.push_back(colour);
      }
      return out;
    };
  };
  return {
      {"a static body counts: it does not move, so any number of joints may hold it at once",
       fit([=](auto, const BodyPair& a, const BodyPair& b) {
         return named(a.body1, b) || named(a.body2, b);
       })},
      {"#moves-turned-round the other way round: the bodies that move are those that no two "
       "joints may share",
       fit([=](auto moves, const BodyPair& a, const BodyPair& b) {
         return (!moves(a.body1) && named(a.body1, b)) || (!moves(a.body2) && named(a.body2, b));
       })},
      {"the colours are counted from 0",
       fit([=](auto moves, const BodyPair& a, const BodyPair& b) {
         return (moves(a.body1) && named(a.body1, b)) || (moves(a.body2) && named(a.body2, b));
       }, 1)},
      {"#only-body-1-asked only body 1 of a joint is tested: the colour must be free at both",
       fit([=](auto moves, const BodyPair& a, const BodyPair& b) {
         return moves(a.body1) && named(a.body1, b);
       })},
      {"only body 2 of a joint is tested: the colour must be free at both",
       fit([=](auto moves, const BodyPair& a, const BodyPair& b) {
         return moves(a.body2) && named(a.body2, b);
       })},
      {"#free-one-them the colour must be free at both bodies: go on while the one or the other "
       "has it",
       always_kept([](auto has, const BodyPair& link) {
         int colour = 0;
         while (has(link.body1, colour) && has(link.body2, colour)) ++colour;
         return colour;
       })},
      {"#body-1-not-asked body 1 is not tested again after the colour has gone up for body 2: go "
       "on until neither of them has it",
       always_kept([](auto has, const BodyPair& link) {
         int colour = 0;
         while (has(link.body1, colour)) ++colour;
         while (has(link.body2, colour)) ++colour;
         return colour;
       })},
      {"#body-2-not-asked body 2 is not tested again after the colour has gone up for body 1: go "
       "on until neither of them has it",
       always_kept([](auto has, const BodyPair& link) {
         int colour = 0;
         while (has(link.body2, colour)) ++colour;
         while (has(link.body1, colour)) ++colour;
         return colour;
       })},
      {"#greater-two-colours the greater one of two colours, each free at one of the bodies: it "
       "must be free at both",
       always_kept([](auto has, const BodyPair& link) {
         int one = 0, two = 0;
         while (has(link.body1, one)) ++one;
         while (has(link.body2, two)) ++two;
         return std::max(one, two);
       })},
      {"#if-place-while the colour goes up once at most: go on while one of the bodies has it, "
       "while and not if",
       always_kept([](auto has, const BodyPair& link) {
         return has(link.body1, 0) || has(link.body2, 0) ? 1 : 0;
       })},
      {"#colour-not-set-back the colour of the last joint is where the next one begins: begin "
       "with 0 for each",
       [](const Scene& scene) {
         int colour = 0;
         return chosen(scene, [&](auto has, const BodyPair& link) {
           while (has(link.body1, colour) || has(link.body2, colour)) ++colour;
           return colour;
         }, [](const BodyPair&, int) { return true; });
       }},
      {"#nothing-taken-beside-static a joint with a static body blocks no colour at all: its "
       "static body alone blocks none, the other one moves",
       [](const Scene& scene) {
         const auto both_move = [&](const BodyPair& link) {
           return scene.moves[std::size_t(link.body1)] && scene.moves[std::size_t(link.body2)];
         };
         return chosen(scene, [&](auto has, const BodyPair& link) {
           int colour = 0;
           while (both_move(link) && (has(link.body1, colour) || has(link.body2, colour)))
             ++colour;
           return colour;
         }, [&](const BodyPair& link, int) { return both_move(link); });
       }},
      {"#nothing-asked-beside-static beside a static body nothing is tested: the other one moves, "
       "and its colour must be free",
       [](const Scene& scene) {
         return chosen(scene, [&](auto has, const BodyPair& link) {
           int colour = 0;
           while (scene.moves[std::size_t(link.body1)] && scene.moves[std::size_t(link.body2)] &&
                  (has(link.body1, colour) || has(link.body2, colour)))
             ++colour;
           return colour;
         }, [](const BodyPair&, int) { return true; });
       }},
      {"#only-joint-before only the joint before is compared: all joints of both bodies count",
       neighbours([](int colour, int other, bool last) {
         return last && other == colour ? 1 : colour;
       })},
      {"#one-more-than-joint one more than the joint before: the least that is free, and all "
       "joints count",
       neighbours([](int colour, int other, bool last) { return last ? other + 1 : colour; })},
      {"#one-more-than-last one more than the last neighbour has: the least that none of them has",
       neighbours([](int, int other, bool) { return other + 1; })},
      {"#joints-before-gone-through the joints before are gone through once: after the colour has "
       "gone up compare all of them again",
       neighbours([](int colour, int other, bool) { return colour + (other == colour); })},
      {"the colour is stored for body 1 of a joint only: it is taken at both",
       fit([=](auto moves, const BodyPair& a, const BodyPair& b) {
         return (moves(a.body1) && a.body1 == b.body1) || (moves(a.body2) && a.body2 == b.body1);
       })},
      {"#kept-body-2-only the colour is stored for body 2 of a joint only: it is taken at both",
       fit([=](auto moves, const BodyPair& a, const BodyPair& b) {
         return (moves(a.body1) && a.body1 == b.body2) || (moves(a.body2) && a.body2 == b.body2);
       })},
      {"body 1 is compared with the bodies 1 of other joints, body 2 with their bodies 2: a body "
       "may be either",
       fit([=](auto moves, const BodyPair& a, const BodyPair& b) {
         return (moves(a.body1) && a.body1 == b.body1) || (moves(a.body2) && a.body2 == b.body2);
       })},
      {"#moves-turned-round-where all have one colour: a joint must not have that of another one "
       "at the same body. Is nothing stored, or is `moves` inverted where it is used?",
       [](const Scene& scene) { return Colours(scene.links.size(), 0); }},
      {"#colour-own every joint has a colour of its own: take the least that is free at its bodies",
       [](const Scene& scene) {
         Colours out(scene.links.size());
         std::iota(out.begin(), out.end(), 0);
         return out;
       }},
      {"#two-in-turn two colours in turn: that fits a chain and nothing else",
       [](const Scene& scene) {
         Colours out;
         for (std::size_t k = 0; k < scene.links.size(); ++k) out.push_back(int(k % 2));
         return out;
       }},
      {"#after-last-one a new colour after the last one that the bodies have: a smaller one may "
       "be free",
       [](const Scene& scene) {
         return counted(scene, [](int& one, int& two, bool moves1, bool moves2) {
           const int colour = std::max(moves1 ? one : 0, moves2 ? two : 0);
           one = std::max(one, colour + 1);
           two = std::max(two, colour + 1);
           return colour;
         });
       }},
      {"the number of joints that a body has so far is not a colour: find the colours that are "
       "taken",
       [](const Scene& scene) {
         return counted(scene, [](int& one, int& two, bool moves1, bool moves2) {
           const int colour = std::max(moves1 ? one : 0, moves2 ? two : 0);
           ++one, ++two;
           return colour;
         });
       }},
      {"#only-last-one-kept only the last colour of a body is kept: it needs all that its joints "
       "have taken",
       [](const Scene& scene) {
         std::vector<int> last(scene.moves.size(), -1);
         Colours out;
         for (const BodyPair& link : scene.links) {
           const auto taken = [&](int body, int colour) {
             return scene.moves[std::size_t(body)] && last[std::size_t(body)] == colour;
           };
           int colour = 0;
           while (taken(link.body1, colour) || taken(link.body2, colour)) ++colour;
           last[std::size_t(link.body1)] = last[std::size_t(link.body2)] = colour;
           out.push_back(colour);
         }
         return out;
       }},
      {"#last-joint-first from the last joint to the first: the first one chooses first",
       [](const Scene& scene) {
         Scene back = scene;
         std::reverse(back.links.begin(), back.links.end());
         Colours out = right_colours(back);
         std::reverse(out.begin(), out.end());
         return out;
       }}};
}
/// The mistakes that give no colours of their own: right ones, or those of a mistake before them.
inline std::vector<std::string> colour_mistakes_alike() {
  std::vector<std::string> out;
  std::vector<std::vector<Colours>> all(1);
  const std::vector<ColourScene> scenes = colour_scenes();
  for (const ColourScene& scene : scenes) all[0].push_back(right_colours(scene));
  for (const ColourMistake& mistake : colour_mistakes()) {
    std::vector<Colours> of;
    for (const ColourScene& scene : scenes) of.push_back(mistake.of(scene));
    if (std::find(all.begin(), all.end(), of) != all.end()) out.push_back(mistake.words);
    all.push_back(of);
  }
  return out;
}

}  // namespace joints::testing
