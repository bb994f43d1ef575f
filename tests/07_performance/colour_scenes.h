// Exercise 7.3 as a list of scenes: which joints may have the same colour.
#pragma once

#include "chapters/07_performance/performance.h"
#include "tests/checker/cases.h"

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
      ring_scene(6), ring_scene(7), net_scene(4), star_scene(40, true), star_scene(70, true),
      {"a chain whose ends come first", {{0, 1}, {3, 4}, {1, 2}, {2, 3}},
       {true, true, true, true, true}},
      {"two joints between the same two bodies", {{0, 1}, {1, 0}, {1, 2}}, {true, true, true}},
      {"joints between static bodies", {{0, 1}, {1, 2}, {0, 1}}, {false, false, true}},
      {"bodies that no joint names", {{1, 4}, {4, 6}},
       {true, true, true, false, true, true, true, true}}};
  for (unsigned seed = 731; seed < 739; ++seed) out.push_back(random_scene(seed));
  return out;
}

}  // namespace joints::testing
