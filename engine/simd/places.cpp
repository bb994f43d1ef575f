// Places of bodies on lanes, and blocks aligned with those of other islands.
#include "engine/simd/places.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace joints {

// ---- the places of bodies -----------------------------------------------------------------------

int Places::root_of(int body) {
  while (root_[body] != body) body = root_[body] = root_[root_[body]];
  return body;
}

// Updates root_ and links_. \return true if the links have not changed
bool Places::find_links(const std::vector<Member>& members) {
  std::iota(root_.begin(), root_.end(), 0);
  std::size_t count = 0;
  bool same = true;
  for (const Member& member : members) {
    const BodyPair& bodies = member.bodies;
    if (bodies.body1 < 0 || bodies.body2 < 0) continue;
    const auto [first, second] = std::minmax({root_of(bodies.body1), root_of(bodies.body2)});
    if (first == second) continue;
    root_[second] = first;
    if (count == links_.size()) links_.emplace_back();
    same = same && links_[count] == bodies;
    links_[count++] = bodies;
  }
  same = same && links_.size() == count;
  links_.resize(count);
  return same;
}

bool Places::place(const std::vector<Member>& members, const std::vector<bool>& moves, int width) {
  root_.resize(moves.size());
  if (find_links(members) && moves == moves_ && width == width_) return false;
  moves_ = moves;
  width_ = width;
  const int bodies = int(moves.size());
  islands_.clear();
  number_.resize(moves.size());
  for (int body = 0; body < bodies; ++body)
    if (moves[body] && root_of(body) == body) {
      number_[body] = int(islands_.size());
      islands_.push_back({.root = body});
    }
  places_.assign(moves.size(), {});
  const auto number = [&](int body) {  // in the order in which links name them
    Island& island = islands_[number_[root_of(body)]];
    int& column = places_[body].column;
    if (column < 0) column = island.size++;
    island.shape = (island.shape ^ std::uint64_t(column + 1)) * 0x100000001b3;  // FNV-1
  };
  for (const BodyPair& link : links_) number(link.body1), number(link.body2);
  for (const Island& island : islands_)
    if (island.size == 0) number(island.root);

  std::sort(islands_.begin(), islands_.end(), [](const Island& a, const Island& b) {
    return std::tuple(-a.size, a.shape, a.root) < std::tuple(-b.size, b.shape, b.root);
  });
  columns_ = 0;
  first_column_.clear();
  for (std::size_t k = 0; k < islands_.size(); ++k) {
    number_[islands_[k].root] = int(k);
    if (k % std::size_t(width) != 0) continue;
    first_column_.push_back(columns_);
    columns_ += 1 + islands_[k].size;
  }
  for (int body = 0; body < bodies; ++body)
    if (moves[body]) {
      Place& place = places_[body];
      place.island = number_[root_of(body)];
      place.column += first_column_[place.island / width] + 1;
    }
  return true;
}

// ---- the groups of blocks -----------------------------------------------------------------------

void Places::append(LaneOrder& order, const std::vector<Member>& members, int first) {
  if (first == 0) {
    order.clear(width_, 0);
    order.columns = true;
    order.bodies.assign(std::size_t(columns_ * width_), -1);
    for (int body = 0; body < int(places_.size()); ++body)
      if (const Place& place = places_[body]; place.island >= 0)
        order.bodies[place.column * width_ + place.island % width_] = body;
  }
  groups_.clear();
  lanes_.clear();
  begin_.assign(first_column_.size(), -1);
  last_.assign(islands_.size(), -1);
  for (int k = first; k < int(members.size()); ++k) {
    const auto& [bodies, kind, follows] = members[k];
    const int island = places_[std::max(bodies.body1, bodies.body2)].island;
    const int batch = island / width_;
    const auto column = [&](int body) {
      return body < 0 ? first_column_[batch] : places_[body].column;
    };
    const BodyPair columns{column(bodies.body1), column(bodies.body2)};
    // the next group of the batch after the island's last one that this block can join
    int& next = last_[island] < 0 ? begin_[batch] : groups_[last_[island]].next;
    int group = next;
    while (group >= 0 && !(groups_[group].columns == columns && groups_[group].kind == kind))
      group = groups_[group].next;
    if (group < 0) {
      group = int(groups_.size());
      const int behind = std::exchange(next, group);
      groups_.push_back({columns, kind, behind});
      lanes_.resize(lanes_.size() + std::size_t(width_), -1);
    }
    lanes_[group * width_ + island % width_] = k;
    last_[island] = group;
  }
  // the first group of every batch, then the second of every batch: neighbours in the order do not
  // wait for each other's velocities
  for (std::erase(begin_, -1); !begin_.empty(); std::erase(begin_, -1))
    for (int& group : begin_) {
      const auto lanes = lanes_.begin() + group * width_;
      order.blocks.insert(order.blocks.end(), lanes, lanes + width_);
      const auto& [columns, kind, next] = groups_[group];
      order.ends.insert(order.ends.end(), {columns.body1, columns.body2});
      group = next;
    }
}

void Places::release() {
  groups_ = std::vector<Group>();  // `= {}` would keep the memory
  lanes_ = std::vector<int>();
  links_.shrink_to_fit();
}

}  // namespace joints
