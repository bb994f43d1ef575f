// Colours, islands and columns.
#include "engine/simd/arrange.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace joints {

Groups one_by_one(int count) { return by_colour(std::vector<int>(std::size_t(count), 0), 1); }

// ---- colours -----------------------------------------------------------------------------------

std::vector<int> greedy_colours(const std::vector<BodyPair>& pairs,
                                const std::vector<bool>& moves) {
  std::vector<std::vector<bool>> taken(moves.size());
  std::vector<int> colours;
  for (const BodyPair& pair : pairs) {
    std::size_t colour = 0;
    const auto is_taken = [&](int body) {
      return colour < taken[body].size() && taken[body][colour];
    };
    while (is_taken(pair.body1) || is_taken(pair.body2)) ++colour;
    for (const int body : {pair.body1, pair.body2}) {
      if (!moves[body]) continue;
      taken[body].resize(std::max(taken[body].size(), colour + 1));
      taken[body][colour] = true;
    }
    colours.push_back(int(colour));
  }
  return colours;
}

Groups by_colour(const std::vector<int>& colours, int width, const std::vector<int>& kinds) {
  std::map<std::pair<int, int>, std::vector<int>> lists;  // colour and kind -> pairs
  for (std::size_t k = 0; k < colours.size(); ++k)
    lists[{colours[k], kinds.empty() ? 0 : kinds[k]}].push_back(int(k));
  Groups groups;
  for (const auto& [key, list] : lists)
    for (std::size_t k = 0; k < list.size(); ++k) {
      if (k % std::size_t(width) == 0) groups.emplace_back();
      groups.back().push_back(list[k]);
    }
  return groups;
}

// ---- islands -----------------------------------------------------------------------------------

Islands islands_of(const std::vector<BodyPair>& pairs, const std::vector<bool>& moves) {
  std::vector<int> root(moves.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int body) {
    while (root[body] != body) body = root[body] = root[root[body]];
    return body;
  };
  for (const BodyPair& pair : pairs)
    if (moves[pair.body1] && moves[pair.body2]) root[find(pair.body1)] = find(pair.body2);
  Islands islands(moves.size());  // by their roots
  for (std::size_t k = 0; k < pairs.size(); ++k)
    islands[find(moves[pairs[k].body1] ? pairs[k].body1 : pairs[k].body2)].push_back(int(k));
  std::erase_if(islands, [](const auto& island) { return island.empty(); });
  return islands;
}

Groups interleaved(const Islands& islands, int width) {
  std::size_t longest = 0;
  for (const auto& island : islands) longest = std::max(longest, island.size());
  Groups groups;
  for (std::size_t k = 0; k < longest; ++k)
    for (std::size_t first = 0; first < islands.size(); first += std::size_t(width)) {
      std::vector<int> group;
      for (std::size_t at = first; at < std::min(islands.size(), first + width); ++at)
        if (k < islands[at].size()) group.push_back(islands[at][k]);
      if (!group.empty()) groups.push_back(group);
    }
  return groups;
}

// The pairs' bodies, numbered as they appear in island after island. A static body of several
// islands has a number in each.
static std::vector<BodyPair> copies_of(const Islands& islands, const std::vector<BodyPair>& pairs) {
  int bodies = 0, next = 0;
  for (const BodyPair& pair : pairs) bodies = std::max({bodies, pair.body1 + 1, pair.body2 + 1});
  std::vector<int> number(std::size_t(bodies), -1);
  std::vector<BodyPair> copies(pairs.size());
  for (const auto& island : islands) {
    const int first = next;
    const auto copy = [&](int body) {
      if (number[body] < first) number[body] = next++;
      return number[body];
    };
    for (const int k : island) {
      copies[k].body1 = copy(pairs[k].body1);
      copies[k].body2 = copy(pairs[k].body2);
    }
  }
  return copies;
}

std::vector<Islands> alike(const Islands& islands, const std::vector<BodyPair>& pairs,
                           const std::vector<int>& kinds) {
  const std::vector<BodyPair> copies = copies_of(islands, pairs);
  std::map<std::vector<int>, Islands> found;
  for (const auto& island : islands) {
    std::vector<int> look;  // of each pair its kind and its two bodies
    const int first = copies[island[0]].body1;
    for (const int k : island)
      look.insert(look.end(), {kinds[k], copies[k].body1 - first, copies[k].body2 - first});
    found[look].push_back(island);
  }
  std::vector<Islands> out;
  for (const auto& [look, list] : found) out.push_back(list);
  return out;
}

// ---- columns -----------------------------------------------------------------------------------

std::optional<Columns> columns_of(const Groups& groups, const Islands& islands,
                                  const std::vector<BodyPair>& pairs, int width) {
  const std::vector<BodyPair> copies = copies_of(islands, pairs);
  std::vector<int> place(2 * pairs.size(), -1);  // of each copy, where it stands in Columns::bodies
  Columns out;
  for (const auto& group : groups) {
    const auto column_of = [&](int BodyPair::*end) -> std::optional<int> {
      int column = -1;  // the same in all lanes: one that a body has already, or a new one
      for (const int pair : group)
        if (const int at = place[copies[pair].*end]; at >= 0) column = at / width;
      if (column < 0) {
        column = int(out.bodies.size()) / width;
        out.bodies.resize(out.bodies.size() + std::size_t(width), -1);
      }
      for (int lane = 0; lane < int(group.size()); ++lane) {
        const int at = column * width + lane, body = pairs[group[lane]].*end;
        int &its = place[copies[group[lane]].*end], &tenant = out.bodies[at];
        if ((its >= 0 && its != at) || (tenant >= 0 && tenant != body)) return {};
        its = at;
        tenant = body;
      }
      return column;
    };
    const auto end1 = column_of(&BodyPair::body1), end2 = column_of(&BodyPair::body2);
    if (!end1 || !end2) return {};
    out.ends.push_back({*end1, *end2});
  }
  return out;
}

}  // namespace joints
