// Colours, islands and columns, over nothing but numbers of bodies.
#include "engine/simd/arrange.h"
#include "tests/checker/catch.h"

using namespace joints;

namespace {

using Numbers = std::vector<int>;
const std::vector<bool> all_move(12, true);

std::vector<bool> but(std::initializer_list<int> still) {
  std::vector<bool> moves = all_move;
  for (const int body : still) moves[std::size_t(body)] = false;
  return moves;
}

}  // namespace

TEST_CASE("the greedy colouring takes the least colour free at both bodies that move") {
  const std::vector<BodyPair> in_order{{0, 1}, {1, 2}, {2, 3}, {3, 4}};
  const std::vector<BodyPair> ends_first{{0, 1}, {3, 4}, {1, 2}, {2, 3}};
  CHECK(greedy_colours(in_order, all_move) == Numbers{0, 1, 0, 1});
  CHECK(greedy_colours(ends_first, all_move) == Numbers{0, 0, 1, 2});
  CHECK(greedy_colours(ends_first, but({2})) == Numbers{0, 0, 1, 1});
}

TEST_CASE("within a colour pairs of one kind come together, as many as there are lanes") {
  const Numbers colours{0, 1, 0, 0, 1, 0};
  CHECK(by_colour(colours, 3) == Groups{{0, 2, 3}, {5}, {1, 4}});
  CHECK(by_colour(colours, 1) == Groups{{0}, {2}, {3}, {5}, {1}, {4}});
  CHECK(by_colour(colours, 3, {7, 7, 5, 7, 5, 7}) == Groups{{2}, {0, 3, 5}, {4}, {1}});
  CHECK(one_by_one(3) == Groups{{0}, {1}, {2}});
}

TEST_CASE("islands hang together by bodies that move and take turns") {
  const std::vector<BodyPair> pairs{{0, 1}, {0, 4}, {1, 2}, {4, 5}, {2, 3}};
  CHECK(islands_of(pairs, all_move).size() == 1);
  const Islands two = islands_of(pairs, but({0}));
  CHECK(two == Islands{{0, 2, 4}, {1, 3}});
  CHECK(interleaved(two, 1) == Groups{{0}, {1}, {2}, {3}, {4}});
  CHECK(interleaved(two, 4) == Groups{{0, 1}, {2, 3}, {4}});
  CHECK(islands_of({}, all_move).empty());
}

TEST_CASE("islands are alike in the kinds of their pairs and in how the bodies hang together") {
  // two chains on one wall, a star on it, and a chain whose second pair is of another kind
  const std::vector<BodyPair> pairs{{0, 1}, {1, 2}, {0, 3}, {3, 4}, {0, 5}, {5, 0}, {0, 6}, {6, 7}};
  const Islands islands = islands_of(pairs, but({0}));
  REQUIRE(islands.size() == 4);
  const auto found = alike(islands, pairs, {1, 1, 1, 1, 1, 1, 1, 2});
  REQUIRE(found.size() == 3);
  CHECK(found[1] == Islands{{0, 1}, {2, 3}});
}

TEST_CASE("columns keep every body in its lane and a static body once an island") {
  const std::vector<BodyPair> pairs{{0, 1}, {1, 2}, {0, 3}, {3, 4}};
  const Islands islands = islands_of(pairs, but({0}));
  const auto columns = columns_of(interleaved(islands, 2), islands, pairs, 2);
  REQUIRE(columns);
  CHECK(columns->bodies == Numbers{0, 0, 1, 3, 2, 4});
  CHECK(columns->ends == std::vector<BodyPair>{{0, 1}, {1, 2}});
  CHECK_FALSE(columns_of({{0, 2}, {3, 1}}, islands, pairs, 2));  // 1 and 3 would change lanes
}
