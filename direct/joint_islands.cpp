// Islands by union and find, their shapes, and the blocks of their systems.
#include "direct/joint_islands.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

namespace joints {

void JointIslands::group(bool changed, int slots, double most_work) {
  for (Island& island : list) island.is_new = false;
  if (!changed && root_.size() == std::size_t(slots) && most_work == most_work_) return;
  most_work_ = most_work;
  keys_.reserve(given.capacity()), order_.reserve(given.capacity()), at_.reserve(given.capacity());
  find_islands(slots);
  find_shapes();
  leave_hubs();
  for (Island& island : list) place_blocks(island);
}

int JointIslands::root_of(int body) {
  while (root_[body] != body) body = root_[body] = root_[root_[body]];
  return body;
}

void JointIslands::find_islands(int slots) {
  root_.resize(std::size_t(slots));
  std::iota(root_.begin(), root_.end(), 0);
  for (const BlockPattern& block : given)
    if (block.rows > 0 && block.moves[0] && block.moves[1])
      root_[root_of(block.bodies.body1)] = root_of(block.bodies.body2);
  first_.assign(std::size_t(slots), -1);  // of each root the first block
  keys_.clear();
  for (int k = 0; k < int(given.size()); ++k) {
    const BlockPattern& block = given[k];
    if (block.rows == 0) continue;
    int& first = first_[root_of_block(k)];
    if (first < 0) first = k;
    keys_.push_back({first, 0, block.optional(), k});
  }
  const auto bodies = [&](const Key& key) {
    const BodyPair& pair = given[key.block].bodies;
    return std::tuple(pair.body1, pair.body2, key.block);
  };
  std::sort(keys_.begin(), keys_.end(),
            [&](const Key& a, const Key& b) { return bodies(a) < bodies(b); });
  for (std::size_t n = 0; n < keys_.size(); ++n) {
    const bool same = n > 0 && given[keys_[n].block].bodies == given[keys_[n - 1].block].bodies;
    keys_[n].link = same ? keys_[n - 1].link : keys_[n].block;
  }
  std::sort(keys_.begin(), keys_.end());

  order_.clear();
  zeros(at_, given.size());
  rows_ = 0;
  std::size_t count = 0;
  for (std::size_t n = 0; n < keys_.size(); ++n) {
    const auto& [first, link, optional, block] = keys_[n];
    if (n == 0 || first != keys_[n - 1].island) {
      if (count++ == list.size()) list.emplace_back();
      Island& now = list[count - 1];
      now.first = int(n), now.first_row = rows_, now.rows = 0;
      now.root = root_of_block(block);
      now.pattern = int(2166136261u >> 8);  // 24 bits, which a float holds as well
    }
    Island& now = list[count - 1];
    const auto& [of, moves, rows, bounded] = given[block];
    for (const int number : {of.body1, of.body2, rows, int(bounded)})
      now.pattern = int((std::uint32_t(now.pattern) ^ std::uint32_t(number)) * 16777619u >> 8);
    at_[block] = {int(count) - 1, 0, rows_};
    order_.push_back(block);
    rows_ += rows;
    now.rows += rows;
    now.end = int(n) + 1;
  }
  list.resize(count);
}

// True if the blocks of a single body, which are all neighbours of each other, already make the
// factor too expensive.
bool JointIslands::is_hub(const Island& island) const {
  double most = 0;
  for (int n = island.first; n < island.end; ++n)
    for (const int body : {given[order_[n]].bodies.body1, given[order_[n]].bodies.body2})
      most = std::max(most, double(count_[body]));
  return most * most * most / 6 > most_work_ * island.rows;
}

// Numbers the bodies of each island in the order in which its links name them. A static body has a
// column for each of its joints. The shape of a hub is empty: its analysis would take too long.
void JointIslands::find_shapes() {
  column_.assign(root_.size(), -1);
  count_.assign(root_.size(), 0);
  for (const BlockPattern& block : given) {
    if (block.moves[0]) count_[block.bodies.body1] += block.rows;
    if (block.moves[1]) count_[block.bodies.body2] += block.rows;
  }
  for (Island& island : list) {
    shape_.clear();
    bodies_.clear();
    island.left = is_hub(island);
    for (int n = island.first, link = -1; n < island.end && !island.left; ++n) {
      if (n == island.first || keys_[n].link != keys_[n - 1].link) ++link;
      else if (keys_[n].optional) continue;
      const auto& [bodies, moves, rows, bounded] = given[keys_[n].block];
      ShapeBlock block{link, {}, moves, rows - bounded};
      for (const int k : {0, 1}) {
        const int body = k == 0 ? bodies.body1 : bodies.body2;
        if (!moves[k] || column_[body] < 0) {
          column_[body] = int(bodies_.size());
          bodies_.push_back(body);
        }
        block.columns[k] = column_[body];
      }
      shape_.push_back(block);
    }
    island.system.bodies = bodies_;
    if (shape_ == island.shape) continue;
    island.shape = shape_;
    island.system.blocks.clear();  // to be placed anew
    island.plan = nullptr;
    if (shape_.empty()) continue;
    std::shared_ptr<const ShapePlan>& plan = plans_[shape_];
    if (!plan) plan = std::make_shared<const ShapePlan>(shape_);
    island.plan = plan;
  }
  if (plans_.size() > 2 * list.size() + 16)
    std::erase_if(plans_, [](const auto& plan) { return plan.second.use_count() == 1; });
}

// Finds the islands that are left to another solver, and those on which blocks without rows act.
void JointIslands::leave_hubs() {
  left_.assign(root_.size(), false);
  bool more = false;
  for (const Island& island : list)
    if (island.left || island.plan->multiplications > most_work_ * island.plan->rows)
      left_[island.root] = more = true;
  while (std::exchange(more, false))
    for (const BlockPattern& block : given) {
      if (!block.moves[0] || !block.moves[1]) continue;
      const int one = root_of(block.bodies.body1), other = root_of(block.bodies.body2);
      if (left_[one] != left_[other]) left_[one] = left_[other] = more = true;
    }
  beside_.assign(root_.size(), false);
  for (const BlockPattern& block : given)
    for (const int k : {0, 1})
      if (block.rows == 0 && block.moves[k])
        beside_[root_of(k == 0 ? block.bodies.body1 : block.bodies.body2)] = true;
}

// Lists the blocks of an island by links in the order of elimination. The first ones of a link are
// those of the shape.
void JointIslands::place_blocks(Island& island) {
  JointSystem& system = island.system;
  island.left = left_[island.root];
  island.alternates = beside_[island.root];
  if (island.left) {
    system.blocks.clear();
    system.bodies.clear();
    return;
  }
  system.moves.resize(system.bodies.size());
  for (const ShapeBlock& block : island.shape)
    for (const int k : {0, 1}) system.moves[block.columns[k]] = block.moves[k];
  begins_.clear();
  for (int n = island.first; n < island.end; ++n)
    if (n == island.first || keys_[n].link != keys_[n - 1].link) begins_.push_back(n);
  begins_.push_back(island.end);
  blocks_.clear();
  blocks_.reserve(system.blocks.capacity());
  for (int place = 0; place < int(island.plan->links.size()); ++place) {
    const int link = island.plan->links[place];
    auto of = std::lower_bound(island.shape.begin(), island.shape.end(), link,
                               [](const ShapeBlock& a, int b) { return a.link < b; });
    SystemBlock block{.place = place, .columns = of->columns};
    for (int n = begins_[link]; n < begins_[link + 1]; ++n) {
      const int k = keys_[n].block;
      block.block = k, block.row = at_[k].row;
      block.rows = given[k].rows, block.bounded = given[k].bounded;
      block.loop = -1;
      if (of != island.shape.end() && of->link == link)
        block.loop = island.plan->of[of++ - island.shape.begin()];
      at_[k].block = int(blocks_.size());
      blocks_.push_back(block);
    }
  }
  const std::vector<SystemBlock>& old = system.blocks;
  island.is_new =
      !std::equal(blocks_.begin(), blocks_.end(), old.begin(), old.end(),
                  [](const SystemBlock& a, const SystemBlock& b) { return a.like(b); });
  for (std::size_t k = 0; k < old.size() && !island.is_new; ++k)
    blocks_[k].node = old[k].node, blocks_[k].first = old[k].first;
  system.blocks.swap(blocks_);
  if (island.is_new) system.lay_out(*island.plan);
}

}  // namespace joints
