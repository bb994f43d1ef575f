// Exercise 7.3 as a list of scenes with the usual mistakes: which joints may have the same colour.
#pragma once

#include <algorithm>
#include <numeric>

#include "chapters/07_performance/performance.h"
#include "tests/checker/cases.h"
#include "tests/checker/report.h"

namespace joints::testing {

inline constexpr Subject colours_subject{"7.3", "the colours of the joints"};

struct ColourScene {
  std::string words;
  std::vector<BodyPair> links;
  std::vector<bool> moves;
};
using Colours = std::vector<int>;

// ---- scenes -------------------------------------------------------------------------------------

/// Body k to body k + 1; body 0 is the wall.
inline ColourScene chain_scene(int joints, bool wall) {
  ColourScene out{"a chain of " + std::to_string(joints) + (wall ? " on a wall" : " in the air"),
                  {}, std::vector<bool>(std::size_t(joints + 1), true)};
  out.moves[0] = !wall;
  for (int k = 0; k < joints; ++k) out.links.push_back({k, k + 1});
  return out;
}
/// Body 0 to each of the others.
inline ColourScene star_scene(int joints, bool hub_moves) {
  ColourScene out{std::string("a star of ") + std::to_string(joints) + " about a hub that " +
                      (hub_moves ? "moves" : "is static"),
                  {}, std::vector<bool>(std::size_t(joints + 1), true)};
  out.moves[0] = hub_moves;
  for (int k = 1; k <= joints; ++k) out.links.push_back(k % 2 ? BodyPair{0, k} : BodyPair{k, 0});
  return out;
}
inline ColourScene ring_scene(int joints) {
  ColourScene out{"a ring of " + std::to_string(joints), {},
                  std::vector<bool>(std::size_t(joints), true)};
  for (int k = 0; k < joints; ++k) out.links.push_back({k, (k + 1) % joints});
  return out;
}
/// A square net of cubes: joints along the rows, then along the columns.
inline ColourScene net_scene(int side) {
  ColourScene out{"a net of " + std::to_string(side) + " by " + std::to_string(side), {},
                  std::vector<bool>(std::size_t(side * side), true)};
  for (int row = 0; row < side; ++row)
    for (int k = 0; k + 1 < side; ++k) out.links.push_back({row * side + k, row * side + k + 1});
  for (int row = 0; row + 1 < side; ++row)
    for (int k = 0; k < side; ++k) out.links.push_back({row * side + k, (row + 1) * side + k});
  out.moves[0] = out.moves[std::size_t(side - 1)] = false;
  return out;
}
/// Joints between any two bodies, a few of which are static.
inline ColourScene random_scene(unsigned seed) {
  Random random(seed);
  const int bodies = 5 + int(seed % 4) * 4;
  const auto any = [&] { return int(random.uniform(0, real(bodies))) % bodies; };
  ColourScene out{"joints at random (seed " + std::to_string(seed) + ")", {}, {}};
  for (int k = 0; k < bodies; ++k) out.moves.push_back(random.uniform(0, 1) < real(0.8));
  for (int k = 0; k < 2 * bodies; ++k) {
    const int body1 = any();
    int body2 = any();
    while (body2 == body1) body2 = any();
    out.links.push_back({body1, body2});
  }
  return out;
}
inline std::vector<ColourScene> colour_scenes() {
  std::vector<ColourScene> out{
      chain_scene(4, true), chain_scene(7, false), star_scene(6, true), star_scene(6, false),
      ring_scene(6), ring_scene(7), net_scene(4),
      {"a chain whose ends come first", {{0, 1}, {3, 4}, {1, 2}, {2, 3}},
       {true, true, true, true, true}},
      {"two joints between the same two bodies", {{0, 1}, {1, 0}, {1, 2}}, {true, true, true}},
      {"joints between static bodies", {{0, 1}, {1, 2}, {0, 1}}, {false, false, true}},
      {"bodies that no joint names", {{1, 4}, {4, 6}},
       {true, true, true, false, true, true, true, true}}};
  for (unsigned seed = 731; seed < 739; ++seed) out.push_back(random_scene(seed));
  return out;
}

// ---- what is right, and what is not -------------------------------------------------------------

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

/// Each joint's colour from what its bodies have seen: a number a body, changed by every joint.
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

struct ColourMistake {
  const char* words;
  std::function<Colours(const ColourScene&)> of;
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
  return {
      {"a static body counts: it does not move, so any number of joints may hold it at once",
       fit([=](auto, const BodyPair& a, const BodyPair& b) {
         return named(a.body1, b) || named(a.body2, b);
       })},
      {"the other way round: the bodies that move are those that no two joints may share",
       fit([=](auto moves, const BodyPair& a, const BodyPair& b) {
         return (!moves(a.body1) && named(a.body1, b)) || (!moves(a.body2) && named(a.body2, b));
       })},
      {"the colours are counted from 0",
       fit([=](auto moves, const BodyPair& a, const BodyPair& b) {
         return (moves(a.body1) && named(a.body1, b)) || (moves(a.body2) && named(a.body2, b));
       }, 1)},
      {"only body 1 of a joint is asked: the colour must be free at both",
       fit([=](auto moves, const BodyPair& a, const BodyPair& b) {
         return moves(a.body1) && named(a.body1, b);
       })},
      {"only body 2 of a joint is asked: the colour must be free at both",
       fit([=](auto moves, const BodyPair& a, const BodyPair& b) {
         return moves(a.body2) && named(a.body2, b);
       })},
      {"the colour must be free at both bodies: go on while the one or the other has it",
       [](const Scene& scene) {
         std::vector<Colours> taken(scene.moves.size());
         Colours out;
         for (const BodyPair& link : scene.links) {
           const auto has = [&](int body, int colour) {
             const Colours& of = taken[std::size_t(body)];
             return scene.moves[std::size_t(body)] &&
                    std::find(of.begin(), of.end(), colour) != of.end();
           };
           int colour = 0;
           while (has(link.body1, colour) && has(link.body2, colour)) ++colour;
           taken[std::size_t(link.body1)].push_back(colour);
           taken[std::size_t(link.body2)].push_back(colour);
           out.push_back(colour);
         }
         return out;
       }},
      {"the colour is kept for body 1 of a joint only: it is taken at both",
       fit([=](auto moves, const BodyPair& a, const BodyPair& b) {
         return (moves(a.body1) && a.body1 == b.body1) || (moves(a.body2) && a.body2 == b.body1);
       })},
      {"the colour is kept for body 2 of a joint only: it is taken at both",
       fit([=](auto moves, const BodyPair& a, const BodyPair& b) {
         return (moves(a.body1) && a.body1 == b.body2) || (moves(a.body2) && a.body2 == b.body2);
       })},
      {"body 1 is compared with the bodies 1 of other joints, body 2 with their bodies 2: a body "
       "may be either",
       fit([=](auto moves, const BodyPair& a, const BodyPair& b) {
         return (moves(a.body1) && a.body1 == b.body1) || (moves(a.body2) && a.body2 == b.body2);
       })},
      {"all have one colour: a joint must not have that of another one at the same body",
       [](const Scene& scene) { return Colours(scene.links.size(), 0); }},
      {"every joint has a colour of its own: take the least that is free at its bodies",
       [](const Scene& scene) {
         Colours out(scene.links.size());
         std::iota(out.begin(), out.end(), 0);
         return out;
       }},
      {"two colours in turn: that fits a chain and nothing else",
       [](const Scene& scene) {
         Colours out;
         for (std::size_t k = 0; k < scene.links.size(); ++k) out.push_back(int(k % 2));
         return out;
       }},
      {"a new colour after the last one that the bodies have: a smaller one may be free",
       [](const Scene& scene) {
         return counted(scene, [](int& one, int& two, bool moves1, bool moves2) {
           const int colour = std::max(moves1 ? one : 0, moves2 ? two : 0);
           one = std::max(one, colour + 1);
           two = std::max(two, colour + 1);
           return colour;
         });
       }},
      {"the number of joints that a body has had so far is no colour: ask which colours are taken",
       [](const Scene& scene) {
         return counted(scene, [](int& one, int& two, bool moves1, bool moves2) {
           const int colour = std::max(moves1 ? one : 0, moves2 ? two : 0);
           ++one, ++two;
           return colour;
         });
       }},
      {"only the last colour of a body is kept: it needs all that its joints have taken",
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
      {"from the last joint to the first: the first one chooses first",
       [](const Scene& scene) {
         Scene back = scene;
         std::reverse(back.links.begin(), back.links.end());
         Colours out = right_colours(back);
         std::reverse(out.begin(), out.end());
         return out;
       }}};
}

// ---- the report ---------------------------------------------------------------------------------

inline Colours your_colours(const ColourScene& scene) {
  return colours_of(scene.links, scene.moves);
}

/// In how many scenes they hold, and the mistake that gives your colours in all of them.
inline std::string explain_colours() {
  const std::vector<ColourScene> scenes = colour_scenes();
  std::vector<Colours> yours;
  std::vector<std::string> holds;
  for (const ColourScene& scene : scenes) {
    yours.push_back(your_colours(scene));
    if (yours.back() == right_colours(scene)) holds.push_back(scene.words);
  }
  std::string out = "Holds in " + std::to_string(holds.size()) + " of " +
                    std::to_string(scenes.size()) + " scenes" +
                    (holds.empty() ? "" : ", such as " + holds.back()) + ".\n";
  if (holds.size() == scenes.size())
    return out + likely("there is a greatest colour: a body may need any number of them");
  for (const ColourMistake& mistake : colour_mistakes()) {
    bool fits = true;
    for (std::size_t k = 0; fits && k < scenes.size(); ++k)
      fits = mistake.of(scenes[k]) == yours[k];
    if (fits) return out + likely(mistake.words);
  }
  return out + "None of the usual mistakes explains it: follow the joints one by one.\n";
}

inline std::string joint_words(const ColourScene& scene, std::size_t k) {
  const BodyPair& link = scene.links[k];
  const auto body = [&](int number) {
    return std::to_string(number) + (scene.moves[std::size_t(number)] ? "" : " (static)");
  };
  return "joint " + std::to_string(k) + " (bodies " + body(link.body1) + " and " +
         body(link.body2) + ")";
}

/// Fails with what is wrong in a scene, and with the mistake that explains it.
[[noreturn]] inline void fail_colours(const ColourScene& scene, const std::string& what) {
  fail(colours_subject, "Scene: " + scene.words + ".\n\n" + what + "\n" + explain_colours());
}

/// A colour for each joint, and each the expected one. Fails with all those that are not.
inline void check_colours(const ColourScene& scene, const Colours& expected) {
  const Colours yours = your_colours(scene);
  if (yours == expected) return check(colours_subject, "");
  if (yours.size() != expected.size())
    fail_colours(scene, "There are " + std::to_string(yours.size()) + " colours for " +
                            std::to_string(expected.size()) + " joints.\n");
  std::string lines;
  int wrong = 0;
  for (std::size_t k = 0; k < expected.size(); ++k)
    if (yours[k] != expected[k] && ++wrong <= 8)
      lines += "  " + joint_words(scene, k) + ": yours " + std::to_string(yours[k]) +
               ", expected " + std::to_string(expected[k]) + "\n";
  if (wrong > 8) lines += "  and " + std::to_string(wrong - 8) + " more\n";
  fail_colours(scene, lines);
}

}  // namespace joints::testing
