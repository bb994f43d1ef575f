// Islands by union and find, their shapes, and pairs of islands with the same shape.
#include "chapters/09_direct/joint_islands.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

namespace joints {

// ---- islands ------------------------------------------------------------------------------------

void JointIslands::group(bool changed, int slots, double most_work) {
  for (IslandPair& pair : pairs) pair.is_new = false;
  if (!changed && root_.size() == std::size_t(slots) && most_work == most_work_) return;
  most_work_ = most_work;
  const auto with_room = [&](auto&... lists) { (lists.reserve(given.capacity()), ...); };
  with_room(keys_, order_, at_);
  find_islands(slots);
  shape_.swap(last_shape_);
  begins_.swap(last_begins_);
  find_shapes();
  const bool new_shapes = shape_ != last_shape_ || begins_ != last_begins_;
  if (new_shapes) find_plans();
  left_.swap(last_left_);
  leave_hubs();
  if (new_shapes || left_ != last_left_) pair_islands();
  for (IslandPair& pair : pairs) place_blocks(pair);
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

  islands_.clear();
  order_.clear();
  zeros(at_, given.size());
  rows_ = 0;
  for (std::size_t n = 0; n < keys_.size(); ++n) {
    const auto& [island, link, optional, block] = keys_[n];
    if (n == 0 || island != keys_[n - 1].island)
      islands_.push_back({.first = int(n), .first_row = rows_, .root = root_of_block(block),
                          .pattern = int(2166136261u >> 1)});
    Island& now = islands_.back();
    const auto& [of, moves, rows, bounded, form] = given[block];
    for (const int number : {of.body1, of.body2, rows, int(bounded)})
      now.pattern = int((std::uint32_t(now.pattern) ^ std::uint32_t(number)) * 16777619u >> 1);
    at_[block] = {int(islands_.size()) - 1, 0, rows_};
    order_.push_back(block);
    rows_ += rows;
    now.rows += rows;
    now.end = int(n) + 1;
  }
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
  shape_.clear();
  begins_.clear();
  links_.clear();
  columns_.clear();
  column_.assign(root_.size(), -1);
  count_.assign(root_.size(), 0);
  for (const BlockPattern& block : given) {
    if (block.moves[0]) count_[block.bodies.body1] += block.rows;
    if (block.moves[1]) count_[block.bodies.body2] += block.rows;
  }
  for (Island& island : islands_) {
    begins_.push_back(int(shape_.size()));
    island.first_link = int(links_.size());
    island.first_column = int(columns_.size());
    const bool hub = is_hub(island);
    for (int n = island.first, link = -1; n < island.end && !hub; ++n) {
      const bool is_first = n == island.first || keys_[n].link != keys_[n - 1].link;
      if (is_first) links_.push_back(n), ++link;
      else if (keys_[n].optional) continue;
      const auto& [bodies, moves, rows, bounded, form] = given[keys_[n].block];
      ShapeBlock block{link, {}, moves, rows - bounded};
      for (const int k : {0, 1}) {
        const int body = k == 0 ? bodies.body1 : bodies.body2;
        if (!moves[k] || column_[body] < 0) {
          column_[body] = int(columns_.size()) - island.first_column;
          columns_.push_back(body);
        }
        block.columns[k] = column_[body];
      }
      shape_.push_back(block);
    }
  }
  begins_.push_back(int(shape_.size()));
  links_.push_back(int(keys_.size()));
}

// ---- pairs --------------------------------------------------------------------------------------

void JointIslands::find_plans() {
  by_shape_.clear();
  for (int k = 0; k < int(islands_.size()); ++k)
    if (!shape(k).empty()) by_shape_.push_back(k);
  const auto less = [&](int a, int b) {
    const auto left = shape(a), right = shape(b);
    return std::lexicographical_compare(left.begin(), left.end(), right.begin(), right.end());
  };
  std::stable_sort(by_shape_.begin(), by_shape_.end(), less);
  plan_.assign(islands_.size(), nullptr);
  for (std::size_t n = 0; n < by_shape_.size(); ++n) {
    const int k = by_shape_[n];
    if (n > 0 && !less(by_shape_[n - 1], k)) {
      plan_[k] = plan_[by_shape_[n - 1]];
      continue;
    }
    const std::vector<ShapeBlock> same(shape(k).begin(), shape(k).end());
    std::shared_ptr<const EliminationPlan>& plan = plans_[same];
    if (!plan) plan = std::make_shared<const EliminationPlan>(same);
    plan_[k] = plan;
  }
}

// Finds the roots of islands that are left to another solver, and those on which blocks without
// rows act.
void JointIslands::leave_hubs() {
  left_.assign(root_.size(), false);
  bool more = false;
  for (std::size_t k = 0; k < islands_.size(); ++k)
    if (!plan_[k] || plan_[k]->multiplications > most_work_ * plan_[k]->rows)
      left_[islands_[k].root] = more = true;
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

// Puts islands of the same shape side by side.
void JointIslands::pair_islands() {
  std::size_t count = 0;
  for (const int k : by_shape_) {
    if (left_[islands_[k].root]) continue;
    IslandPair* const last = count > 0 ? &pairs[count - 1] : nullptr;
    if (last && last->islands[1] < 0 && last->plan == plan_[k]) {
      last->islands[1] = k;
      continue;
    }
    if (count == pairs.size()) pairs.emplace_back();
    IslandPair& pair = pairs[count++];
    pair.islands = {k, -1};
    pair.blocks.clear();  // to be placed anew
    pair.has_room = false;
    pair.plan = plan_[k];
  }
  pairs.resize(count);
  if (plans_.size() > 2 * pairs.size() + 16)
    std::erase_if(plans_, [](const auto& plan) { return plan.second.use_count() == 1; });
}

// Lists the blocks of a pair by links in the order of elimination, those of both lanes side by
// side. The first ones of a link are those of the shape.
void JointIslands::place_blocks(IslandPair& pair) {
  const auto shape = this->shape(pair.islands[0]);
  pair.bodies.clear();
  pair.alternates = false;
  for (const ShapeBlock& block : shape)
    for (const int k : {0, 1}) {
      const std::size_t column = std::size_t(block.columns[k]);
      if (column == pair.bodies.size()) pair.bodies.push_back({-1, -1});
      pair.moves.resize(pair.bodies.size());
      pair.moves[column] = block.moves[k];
    }
  for (const int lane : {0, 1}) {
    if (pair.islands[lane] < 0) continue;
    Island& island = islands_[pair.islands[lane]];
    island.pair = int(&pair - pairs.data());
    island.lane = lane;
    pair.alternates = pair.alternates || beside_[island.root];
    for (std::size_t k = 0; k < pair.bodies.size(); ++k)
      pair.bodies[k][lane] = columns_[std::size_t(island.first_column) + k];
  }
  blocks_.clear();
  blocks_.reserve(pair.blocks.capacity());
  bool bounded = false;
  int node = -1;
  for (int place = 0; place < int(pair.plan->links.size()); ++place) {
    const int link = pair.plan->links[place];
    auto like = std::lower_bound(shape.begin(), shape.end(), link,
                                 [](const ShapeBlock& a, int b) { return a.link < b; });
    LaneBlock block{.place = place, .columns = like->columns};
    int rows = most_rows;  // of the last node
    for (int n = 0;; ++n) {
      block.own = {};
      block.block = {-1, -1};
      block.bounded = false;
      for (const int lane : {0, 1}) {
        if (pair.islands[lane] < 0) continue;
        const Island& island = islands_[pair.islands[lane]];
        const int key = links_[island.first_link + link] + n;
        if (key >= std::min(links_[island.first_link + link + 1], island.end)) continue;
        block.block[lane] = keys_[key].block;
        block.row[lane] = at_[keys_[key].block].row;
        const BlockPattern& pattern = given[keys_[key].block];
        block.form = block.lanes() == 0 || block.form == pattern.form ? pattern.form : Form::any;
        block.own[lane] = pattern.rows;
        block.bounded = block.bounded || pattern.bounded;
        bounded = bounded || pattern.bounded;
      }
      if (block.lanes() == 0) break;
      block.rows = std::max(block.own[0], block.own[1]);
      if (rows + block.rows > most_rows) ++node, rows = 0;
      block.node = node;
      block.first = std::exchange(rows, rows + block.rows);
      block.loop = -1;
      if (like != shape.end() && like->link == link)
        block.loop = pair.plan->loop[like++ - shape.begin()];
      blocks_.push_back(block);
    }
  }
  pair.is_new = !std::equal(blocks_.begin(), blocks_.end(), pair.blocks.begin(), pair.blocks.end(),
                            [](const LaneBlock& a, const LaneBlock& b) { return a.like(b); });
  pair.blocks.swap(blocks_);
  if (pair.is_new) pair.lay_out();
  if (bounded && !std::exchange(pair.has_room, true)) pair.make_room();
  for (int k = 0; k < int(pair.blocks.size()); ++k)
    for (const int block : pair.blocks[k].block)
      if (block >= 0) at_[block].block = k;
}

}  // namespace joints
