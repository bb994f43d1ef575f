// Islands, over nothing but numbers of bodies.
#include "engine/simd/arrange.h"
#include "tests/checker/catch.h"

using namespace joints;

namespace {

const std::vector<bool> all_move(12, true);

std::vector<bool> but(std::initializer_list<int> still) {
  std::vector<bool> moves = all_move;
  for (const int body : still) moves[std::size_t(body)] = false;
  return moves;
}

}  // namespace

TEST_CASE("islands are connected by bodies that move") {
  const std::vector<BodyPair> pairs{{0, 1}, {0, 4}, {1, 2}, {4, 5}, {2, 3}};
  CHECK(islands_of(pairs, all_move).size() == 1);
  CHECK(islands_of(pairs, but({0})) == Islands{{0, 2, 4}, {1, 3}});
  CHECK(islands_of({}, all_move).empty());
}

TEST_CASE("islands are alike in the kinds of their pairs and in how their bodies are connected") {
  // two chains on one wall, a star on it, and a chain whose second pair is of another kind
  const std::vector<BodyPair> pairs{{0, 1}, {1, 2}, {0, 3}, {3, 4}, {0, 5}, {5, 0}, {0, 6}, {6, 7}};
  const Islands islands = islands_of(pairs, but({0}));
  REQUIRE(islands.size() == 4);
  const auto found = alike(islands, pairs, {1, 1, 1, 1, 1, 1, 1, 2});
  REQUIRE(found.size() == 3);
  CHECK(found[1] == Islands{{0, 1}, {2, 3}});
}
