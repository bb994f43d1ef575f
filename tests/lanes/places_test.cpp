// Orders of blocks over nothing but numbers of bodies: by colours, and by islands on lanes.
#include <algorithm>
#include <set>

#include "engine/simd/places.h"
#include "tests/checker/catch.h"
#include "tests/oracle/oracle.h"

using namespace joints;
using namespace joints::testing;

namespace {

using Numbers = std::vector<int>;
using Members = std::vector<Member>;

int integer(Random& random, int low, int high) {
  return std::min(high, low + int(random.uniform(0, real(high - low + 1))));
}

LaneOrder coloured(const Members& members, int width, int bodies) {
  LaneOrder order;
  order.clear(width, bodies);
  GreedyColours().append(order, members, 0);
  return order;
}

// What any order has to keep, with some blocks appended later than others.
void check_order(const LaneOrder& order, const Members& members, bool islands) {
  const int width = order.width;
  Numbers seen;
  for (int group = 0; group < order.groups(); ++group) {
    std::set<int> bodies, kinds;
    int moving = 0;
    for (int lane = 0; lane < width; ++lane) {
      const int block = order.blocks[std::size_t(group * width + lane)];
      if (block < 0) continue;
      seen.push_back(block);
      const Member& member = members[std::size_t(block)];
      kinds.insert(member.kind);
      for (const bool second : {false, true}) {
        const int body = second ? member.bodies.body2 : member.bodies.body1;
        const int record =
            order.columns
                ? order.ends[std::size_t(2 * group + second)] * width + lane
                : order.ends[std::size_t((2 * group + second) * width + lane)];
        CHECK(order.bodies[std::size_t(record)] == body);  // -1 where none moves
        if (body < 0) continue;
        bodies.insert(body);
        ++moving;
      }
      if (member.bodies.body1 == member.bodies.body2) --moving;
    }
    CHECK(kinds.size() == 1);
    CHECK(int(bodies.size()) == moving);  // none twice
  }
  if (islands)  // of two blocks that share a body the one of the list comes first
    for (std::size_t a = 0; a < seen.size(); ++a)
      for (std::size_t b = a + 1; b < seen.size(); ++b) {
        const BodyPair &one = members[std::size_t(seen[a])].bodies,
                       &other = members[std::size_t(seen[b])].bodies;
        const auto shared = [&](int body) {
          return body >= 0 && (body == other.body1 || body == other.body2);
        };
        if (shared(one.body1) || shared(one.body2)) CHECK(seen[a] < seen[b]);
      }
  std::sort(seen.begin(), seen.end());
  Numbers all(members.size());
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = int(k);
  CHECK(seen == all);
}

}  // namespace

TEST_CASE("the greedy colouring takes the least colour free at both bodies that move") {
  const Members in_order{{{0, 1}}, {{1, 2}}, {{2, 3}}, {{3, 4}}};
  const Members ends_first{{{0, 1}}, {{3, 4}}, {{1, 2}}, {{2, 3}}};
  Members held = ends_first;  // by body 2
  held[2].bodies.body2 = held[3].bodies.body1 = -1;
  CHECK(coloured(in_order, 2, 5).blocks == Numbers{0, 2, 1, 3});
  CHECK(coloured(ends_first, 2, 5).blocks == Numbers{0, 1, 2, -1, 3, -1});
  CHECK(coloured(held, 2, 5).blocks == Numbers{0, 1, 2, 3});
}

TEST_CASE("within a colour blocks of one kind come together, as many as there are lanes") {
  Members apart;
  for (const int kind : {7, 5, 7, 7, 5, 7}) {
    const int body = 2 * int(apart.size());
    apart.push_back({{body, body + 1}, kind});
  }
  CHECK(coloured(apart, 3, 12).blocks == Numbers{1, 4, -1, 0, 2, 3, 5, -1, -1});
  CHECK(coloured(apart, 1, 12).blocks == Numbers{1, 4, 0, 2, 3, 5});
  LaneOrder order;
  order.clear(1, 12);
  append_in_turn(order, apart, 0);
  CHECK(order.blocks == Numbers{0, 1, 2, 3, 4, 5});
  CHECK(order.ends == Numbers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
}

TEST_CASE("islands that are alike come side by side, and what differs in one is inserted") {
  // Two chains of three bodies on a wall; the second has a row of kind 3 more.
  const Members members{{{-1, 0}, 1}, {{0, 1}, 1}, {{1, 2}, 2},
                        {{-1, 3}, 1}, {{3, 4}, 1}, {{3, 4}, 3}, {{4, 5}, 2}};
  Places places;
  LaneOrder order;
  places.place(members, std::vector<bool>(6, true), 2);
  places.append(order, members, 0);
  CHECK(order.blocks == Numbers{0, 3, 1, 4, -1, 5, 2, 6});
  CHECK(order.bodies == Numbers{-1, -1, 0, 3, 1, 4, 2, 5});
  CHECK(order.ends == Numbers{0, 1, 1, 2, 1, 2, 2, 3});
  check_order(order, members, true);

  Places in_turn;  // without lanes: by turns
  in_turn.place(members, std::vector<bool>(6, true), 1);
  in_turn.append(order, members, 0);
  CHECK(order.blocks == Numbers{0, 3, 1, 4, 2, 5, 6});
}

TEST_CASE("places stay until islands are connected otherwise or a body begins to move or stops") {
  const Members chains{{{0, 1}}, {{2, 3}}};
  std::vector<bool> moves(6, true);
  moves[5] = false;
  Places places;
  const auto new_with = [&](const Members& more) {
    Members members = chains;
    members.insert(members.end(), more.begin(), more.end());
    const bool anew = places.place(members, moves, 4);
    LaneOrder order;
    places.append(order, members, 0);
    check_order(order, members, true);
    return anew;
  };
  CHECK(new_with({}));
  CHECK_FALSE(new_with({}));
  CHECK_FALSE(new_with({{{1, 0}}, {{1, 0}, 7}, {{-1, 3}}, {{2, -1}, 2}}));  // of one island
  CHECK_FALSE(new_with({{{4, -1}}}));  // an island of its own, though no block named it
  CHECK(new_with({{{1, 2}}}));         // connects both
  CHECK(places.links().size() == 3);
  CHECK_FALSE(new_with({{{1, 2}}}));
  CHECK(new_with({}));
  CHECK(new_with({{{4, 0}}}));
  moves[5] = true;
  CHECK(new_with({{{4, 0}}, {{5, -1}}}));
  moves.push_back(true);  // one more body
  CHECK(new_with({{{4, 0}}, {{-1, 6}}}));
  CHECK(places.place(chains, moves, 2));  // another width
}

TEST_CASE("in random islands whose blocks come and go every order keeps what it has to") {
  Random random(95);
  for (int draw = 0; draw < 40; ++draw) {
    const int width = 1 << integer(random, 0, 3), bodies = integer(random, 6, 60);
    std::vector<int> island;  // of each body
    for (int k = 0; k < bodies; ++k) island.push_back(integer(random, 0, 12));
    std::vector<bool> moves;
    for (int k = 0; k < bodies; ++k) moves.push_back(integer(random, 0, 9) > 0);
    const auto block = [&]() -> Member {
      for (;;) {
        const int a = integer(random, 0, bodies - 1), b = integer(random, 0, bodies - 1);
        const int kind = integer(random, 0, 2);
        if (!moves[a] || (a == b && kind > 0) || (moves[b] && island[a] != island[b])) continue;
        return {{a, moves[b] ? b : -1}, kind};
      }
    };
    Members members;
    for (int k = 0; k < 3 * bodies; ++k) members.push_back(block());
    Places places;
    LaneOrder order;
    for (int change = 0; change < 5; ++change) {
      places.place(members, moves, width);
      const int late = int(members.size());
      places.append(order, members, 0);
      check_order(order, members, true);
      for (int k = 0; k < 5; ++k) {  // connected as before: late blocks come behind
        Member more = members[std::size_t(integer(random, 0, late - 1))];
        more.kind += 10;
        members.push_back(more);
      }
      REQUIRE_FALSE(places.place(members, moves, width));
      places.append(order, members, late);
      check_order(order, members, true);
      LaneOrder colours;
      colours.clear(width, bodies);
      GreedyColours by;
      by.append(colours, members, 0);
      check_order(colours, members, false);
      for (std::size_t k = members.size() / 3; k > 0; --k)
        members.erase(members.begin() + integer(random, 0, int(members.size()) - 1));
    }
  }
}
