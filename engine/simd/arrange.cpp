// Finds islands, and sets of islands with the same structure.
#include "engine/simd/arrange.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace joints {

Islands islands_of(const std::vector<BodyPair>& pairs, const std::vector<bool>& moves) {
  std::vector<int> root(moves.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int body) {
    while (root[body] != body) body = root[body] = root[root[body]];
    return body;
  };
  for (const BodyPair& pair : pairs)
    if (moves[pair.body1] && moves[pair.body2]) root[find(pair.body1)] = find(pair.body2);
  Islands islands(moves.size());  // indexed by root
  for (std::size_t k = 0; k < pairs.size(); ++k)
    islands[find(moves[pairs[k].body1] ? pairs[k].body1 : pairs[k].body2)].push_back(int(k));
  std::erase_if(islands, [](const auto& island) { return island.empty(); });
  return islands;
}

// The pairs with their bodies renumbered in the order in which the islands mention them. A static
// body gets one number per island.
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
    std::vector<int> shape;  // the kind and the two renumbered bodies of each pair
    const int first = copies[island[0]].body1;
    for (const int k : island)
      shape.insert(shape.end(), {kinds[k], copies[k].body1 - first, copies[k].body2 - first});
    found[shape].push_back(island);
  }
  std::vector<Islands> out;
  for (const auto& [shape, list] : found) out.push_back(list);
  return out;
}

}  // namespace joints
