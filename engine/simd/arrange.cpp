// Who is solved side by side, and when: islands of joints that are alike, or colours.
#include <algorithm>
#include <map>
#include <numeric>

#include "engine/simd/packed.h"

namespace joints {

namespace {

bool still1(int kind) { return kind & 2; }
bool still2(int kind) { return kind & 1; }

}  // namespace

void PackedBlocks::arrange(const Bodies& bodies, Packing packing) {
  groups.clear();
  blocks.clear();
  ends.clear();
  numbers_.clear();
  columns_ = false;
  slots_.resize(std::size_t(bodies.slots()) + 1);
  std::iota(slots_.begin(), slots_.end(), 0);
  slots_.back() = -1;  // belongs to lanes that are not used
  records_.assign(slots_.size(), {});
  if (packing == Packing::list)
    for (int k = 0; k < int(signs_.size()); ++k) add_group(&k, 1);
  else if (packing == Packing::colours)
    arrange_colours(bodies);
  else if (const Islands islands = find_islands(bodies); width_ == 1)
    interleave(islands);
  else if (!arrange_islands(bodies, islands))
    arrange_colours(bodies);
  place_sums();
}

// Neighbours get different colours: each block takes the first one that none of its two moving
// bodies has yet. Within a colour, like blocks come together.
void PackedBlocks::arrange_colours(const Bodies& bodies) {
  std::vector<std::vector<bool>> taken(std::size_t(bodies.slots()));
  std::vector<std::map<int, std::vector<int>>> colours;  // of each colour: kind -> blocks
  for (int k = 0; k < int(signs_.size()); ++k) {
    const Sign& sign = signs_[k];
    std::vector<int> moving;
    if (!still1(sign.kind)) moving.push_back(sign.body1);
    if (!still2(sign.kind)) moving.push_back(sign.body2);
    std::size_t colour = 0;
    const auto is_taken = [&](int body) {
      return colour < taken[body].size() && taken[body][colour];
    };
    while (std::any_of(moving.begin(), moving.end(), is_taken)) ++colour;
    for (const int body : moving) {
      if (taken[body].size() <= colour) taken[body].resize(colour + 1);
      taken[body][colour] = true;
    }
    if (colours.size() <= colour) colours.resize(colour + 1);
    colours[colour][sign.kind / 4].push_back(k);
  }
  for (const auto& colour : colours)
    for (const auto& [kind, list] : colour)
      for (std::size_t at = 0; at < list.size(); at += std::size_t(width_))
        add_group(&list[at], std::min(width_, int(list.size() - at)));
}

// Islands that hang together by bodies that move, each in the order of the list.
PackedBlocks::Islands PackedBlocks::find_islands(const Bodies& bodies) const {
  std::vector<int> root(std::size_t(bodies.slots()));
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int body) {
    while (root[body] != body) body = root[body] = root[root[body]];
    return body;
  };
  for (const Sign& sign : signs_)
    if (!still1(sign.kind) && !still2(sign.kind)) root[find(sign.body1)] = find(sign.body2);
  std::map<int, std::vector<int>> islands;  // root -> its blocks
  for (int k = 0; k < int(signs_.size()); ++k)
    islands[find(still1(signs_[k].kind) ? signs_[k].body2 : signs_[k].body1)].push_back(k);
  Islands out;
  for (const auto& [body, list] : islands) out.push_back(list);
  return out;
}

// The first block of every island, then the second of every one: none has to wait for the one
// before.
void PackedBlocks::interleave(const Islands& islands) {
  std::size_t longest = 0;
  for (const auto& island : islands) longest = std::max(longest, island.size());
  for (std::size_t k = 0; k < longest; ++k)
    for (const auto& island : islands)
      if (k < island.size()) add_group(&island[k], 1);
}

// Islands that are alike, block by block, a lane each: then no body is in two lanes, and its record
// can stand as the lanes want it, in a column. Returns false where fewer than half of the lanes
// would be used.
bool PackedBlocks::arrange_islands(const Bodies& bodies, const Islands& islands) {
  // What a island looks like: of each block its kind and its two bodies, counted as they appear.
  struct Island {
    const std::vector<int>* list;
    std::vector<int> slots;  // in the order in which they appear
  };
  std::map<std::vector<int>, std::vector<Island>> alike;
  std::vector<int> place(std::size_t(bodies.slots()), -1);
  for (const auto& list : islands) {
    Island island{&list, {}};
    std::vector<int> look;
    const auto place_of = [&](int slot) {
      if (place[slot] < 0) {
        place[slot] = int(island.slots.size());
        island.slots.push_back(slot);
      }
      return place[slot];
    };
    for (const int k : list) {
      const Sign& sign = signs_[k];
      look.insert(look.end(), {sign.kind, place_of(sign.body1), place_of(sign.body2)});
    }
    for (const int slot : island.slots) place[slot] = -1;
    alike[look].push_back(island);
  }
  const std::size_t width = std::size_t(width_);
  std::size_t used = 0, lanes = 0;
  for (const auto& [look, list] : alike) {
    used += look.size() * list.size();
    lanes += look.size() * ((list.size() + width - 1) / width * width);
  }
  if (2 * used < lanes) return false;

  columns_ = true;
  slots_.clear();
  for (const auto& [look, list] : alike) {
    const std::size_t bodies_each = list[0].slots.size(), before = slots_.size() / width;
    for (std::size_t at = 0; at < list.size(); at += width)
      for (std::size_t body = 0; body < bodies_each; ++body)
        for (std::size_t lane = 0; lane < width; ++lane)
          slots_.push_back(at + lane < list.size() ? list[at + lane].slots[body] : -1);
    for (std::size_t k = 0; k < look.size() / 3; ++k)
      for (std::size_t at = 0; at < list.size(); at += width) {
        std::vector<int> same;
        for (std::size_t island = at; island < std::min(list.size(), at + width); ++island)
          same.push_back((*list[island].list)[k]);
        const int column = int(before + at / width * bodies_each);
        add_group(same.data(), int(same.size()));
        ends.resize(ends.size() - 2 * width);
        ends.insert(ends.end(), {column + look[3 * k + 1], column + look[3 * k + 2]});
      }
  }
  records_.assign(slots_.size(), {});
  return true;
}

// A group of blocks of one kind; `list` names them.
void PackedBlocks::add_group(const int* list, int count) {
  const int kind = signs_[list[0]].kind / 4;
  LaneGroup group{kind / 8 % 8, bool(kind & 4), bool(kind & 2), bool(kind & 1), bool(kind & 64),
                  int(numbers_.size()) * lane_count, int(ends.size())};
  const int size = size_of(group) * width_;
  numbers_.resize(numbers_.size() + std::size_t(size + lane_count - 1) / lane_count, {});
  for (int lane = 0; lane < width_; ++lane) blocks.push_back(lane < count ? list[lane] : -1);
  const int nobody = int(slots_.size()) - 1;
  for (int lane = 0; lane < width_; ++lane)
    ends.push_back(lane < count ? signs_[list[lane]].body1 : nobody);
  for (int lane = 0; lane < width_; ++lane)
    ends.push_back(lane < count ? signs_[list[lane]].body2 : nobody);
  groups.push_back(group);
}

}  // namespace joints
