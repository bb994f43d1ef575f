// Packs the blocks of a step into groups, and solves them.
#include "engine/simd/packed.h"

#include <algorithm>
#include <set>

namespace joints {

namespace {

// True if the first three rows hold two points together and the others are angular with w1 = -w2:
// then J is two levers and N - 3 axes.
bool holds_a_point(const Row* J, int rows) {
  if (rows < 3) return false;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const real one = k == i ? real(1) : real(0);
      if (J[i].v1[k] != -one || J[i].v2[k] != one) return false;
      // w1 and w2 are skew matrices of the levers: antisymmetric
      if (k <= i && (J[i].w1[k] != -J[k].w1[i] || J[i].w2[k] != -J[k].w2[i])) return false;
    }
  for (int i = 3; i < rows; ++i)
    for (int k = 0; k < 3; ++k)
      if (J[i].v1[k] != 0 || J[i].v2[k] != 0 || J[i].w1[k] != -J[i].w2[k]) return false;
  return true;
}

BlockKind kind_of(const Bodies& bodies, const Blocks& list, const PreparedBlock& block) {
  const bool follows = block.followed >= 0;
  const bool point = !follows && holds_a_point(&list.J[block.first], block.rows);
  const bool hard = !follows && block.impulse_scale == 0 && block.lower == -unbounded &&
                    block.upper == unbounded;
  const bool isotropic = point && bodies.at(block.body1).is_isotropic() &&
                         bodies.at(block.body2).is_isotropic();
  return {static_cast<signed char>(block.rows), point, hard, isotropic, follows};
}

// ---- the numbers of a block ---------------------------------------------------------------------

// What a record is filled from.
struct Source {
  const PreparedBlock& block;
  const Row* J;
  const PreparedRow* row;
  const real* inverse_K;
  const Body &body1, &body2;
};

// Writes the numbers of one block into one lane of its group's record; a scalar record has one.
template <int N, bool isotropic, class Number>
void fill_rows(PointRows<N, isotropic, Number>& rows, const Source& from, int lane) {
  const Row* const J = from.J;
  scatter(Triple<real>{J[2].w1.y, J[0].w1.z, J[1].w1.x}, rows.r1, lane);
  scatter(Triple<real>{-J[2].w2.y, -J[0].w2.z, -J[1].w2.x}, rows.r2, lane);
  if constexpr (isotropic) {
    scatter(from.body1.inverse_inertia_local.x, rows.I1, lane);
    scatter(from.body2.inverse_inertia_local.x, rows.I2, lane);
  } else {
    scatter(symmetric(inverse_inertia(from.body1)), rows.I1, lane);
    scatter(symmetric(inverse_inertia(from.body2)), rows.I2, lane);
  }
  for (int i = 0; i < N; ++i) scatter(from.row[i].bias, rows.bias[i], lane);
  for (int i = 3; i < N; ++i) scatter(triple(J[i].w2), rows.axis[i - 3], lane);
}

template <int N, class Number>
void fill_rows(AnyRows<N, Number>& rows, const Source& from, int lane) {
  for (int i = 0; i < N; ++i) {
    const Row& J = from.J[i];
    scatter(from.row[i].bias, rows.bias[i], lane);
    scatter(typename AnyRows<N, real>::Row{triple(J.v1), triple(J.w1), triple(J.v2), triple(J.w2),
                                           triple(from.row[i].response_w1),
                                           triple(from.row[i].response_w2)},
            rows.row[i], lane);
  }
}

template <class Rows, int N, bool hard, class Number>
void fill(Record<Rows, N, hard, Number>& record, const Source& from, int lane) {
  const PreparedBlock& block = from.block;
  fill_rows(record.rows, from, lane);
  Number* inverse_K = record.impulses.inverse_K;
  for (int i = 0; i < N; ++i) scatter(block.impulse[i], record.impulses.lambda[i], lane);
  for (int i = 0; i < N; ++i)
    for (int j = i; j < N; ++j)
      scatter(block.mass_scale * from.inverse_K[i * N + j], *inverse_K++, lane);
  if constexpr (!hard) {
    scatter(block.impulse_scale, record.bounds.impulse_scale, lane);
    scatter(block.lower, record.bounds.lower, lane);
    scatter(block.upper, record.bounds.upper, lane);
    for (int i = 0; i < N; ++i)
      scatter(from.row[i].clamp_response, record.bounds.clamp_response[i], lane);
  }
}

// move_bounds() sets its bounds before every solve.
template <class Number>
void fill(FollowingRecord<Number>& record, const Source& from, int lane) {
  fill<AnyRows<1, Number>, 1, false>(record, from, lane);
  scatter(from.block.upper, record.factor, lane);
}

}  // namespace

// ---- the groups ---------------------------------------------------------------------------------

void PackedBlocks::arrange(const Bodies& bodies, Packing packing) {
  groups.clear();
  blocks.clear();
  numbers_.clear();
  std::vector<BodyPair> pairs;
  std::vector<bool> moves(std::size_t(bodies.slots()));
  std::set<BlockKind> present;
  for (const Signature& one : signatures_) {
    pairs.push_back(one.bodies);
    moves[one.bodies.body1] = !one.static1;
    moves[one.bodies.body2] = !one.static2;
    present.insert(one.kind);
  }
  std::vector<int> kinds;  // for each block, the index of its kind
  for (const Signature& one : signatures_)
    kinds.push_back(int(std::distance(present.begin(), present.find(one.kind))));

  Groups found;
  std::optional<Columns> columns;
  if (packing == Packing::list) found = one_by_one(int(pairs.size()));
  if (packing == Packing::islands) {
    const Islands islands = islands_of(pairs, moves);
    if (width_ == 1) {
      found = interleaved(islands, 1);
    } else {
      for (const Islands& same : alike(islands, pairs, kinds))
        for (const auto& group : interleaved(same, width_)) found.push_back(group);
      if (2 * pairs.size() < found.size() * std::size_t(width_))
        found.clear();  // more than half of the lanes would be unused: take colours
      else
        columns = columns_of(found, islands, pairs, width_);
    }
  }
  if (found.empty()) found = by_colour(greedy_colours(pairs, moves), width_, kinds);
  records_.arrange(found, pairs, columns, bodies.slots(), width_);
  for (const auto& group : found) add_group(group);
  find_followed();
}

// Allocates the record of a group of blocks of one kind.
void PackedBlocks::add_group(const std::vector<int>& members) {
  LaneGroup group{signatures_[members[0]].kind};
  group.first = int(numbers_.size()) * lane_count;
  LaneNumber any;  // never read: only the size of the record is used
  use_record<real>(group, any.lane, [&](auto& record) {
    const std::size_t size = sizeof record / sizeof(real) * std::size_t(width_);
    group.first_lambda = group.first + int(sizeof record.rows / sizeof(real)) * width_;
    numbers_.resize(numbers_.size() + (size + lane_count - 1) / lane_count, {});
  });
  for (int lane = 0; lane < width_; ++lane)
    blocks.push_back(lane < int(members.size()) ? members[lane] : -1);
  groups.push_back(group);
}

// Fills followed_: where each following row finds the impulse that it follows.
void PackedBlocks::find_followed() {
  followed_.clear();
  if (std::none_of(groups.begin(), groups.end(),
                   [](const BlockKind& kind) { return kind.follows; }))
    return;
  std::vector<int> first_row, place;  // block -> its first row; row -> index of its lambda
  for (const Signature& one : signatures_) {
    first_row.push_back(int(place.size()));
    place.resize(place.size() + std::size_t(one.kind.rows));
  }
  for (std::size_t k = 0; k < blocks.size(); ++k)
    for (int row = 0; blocks[k] >= 0 && row < groups[k / width_].rows; ++row)
      place[first_row[blocks[k]] + row] = lambda_index(groups[k / width_], row, int(k) % width_);
  followed_.assign(blocks.size(), 0);
  for (std::size_t k = 0; k < blocks.size(); ++k)
    if (blocks[k] >= 0 && signatures_[blocks[k]].kind.follows)
      followed_[k] = place[signatures_[blocks[k]].followed];
}

// ---- a step -------------------------------------------------------------------------------------

void PackedBlocks::pack(const Bodies& bodies, const Blocks& list, const Prepared& prepared,
                        Packing packing, bool lanes) {
  const int width = lanes && packing != Packing::list ? lane_count : 1;
  now_.clear();
  for (const PreparedBlock& block : prepared.blocks)
    now_.push_back({kind_of(bodies, list, block), bodies.at(block.body1).is_static(),
                    bodies.at(block.body2).is_static(), {block.body1, block.body2},
                    block.followed});
  if (packing != packing_ || width != width_ || now_ != signatures_) {
    signatures_ = now_;
    packing_ = packing;
    width_ = width;
    ++groupings_;
    arrange(bodies, packing);
  }
  records_.take([&](int slot) -> const Body& { return bodies.at(slot); });
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    if (blocks[k] < 0) continue;
    const PreparedBlock& block = prepared.blocks[blocks[k]];
    const LaneGroup& group = groups[k / width_];
    const Source from{block, &list.J[block.first], &prepared.rows[block.first],
                      &prepared.inverse_K[block.first_K], bodies.at(block.body1),
                      bodies.at(block.body2)};
    const int lane = int(k) % width_;
    const auto fill_lane = [&](auto& record) { fill(record, from, lane); };
    if (width_ == 1)
      use_record<real>(group, numbers() + group.first, fill_lane);
    else
      use_record<LaneNumber>(group, numbers() + group.first, fill_lane);
  }
}

void PackedBlocks::iterate() {
  const LaneIteration all{groups.data(), int(groups.size()), numbers(), followed_.data(),
                          records_.view()};
  width_ == 1 ? iterate_single(all) : iterate_lanes(all);
}

void PackedBlocks::unpack(Bodies& bodies, const Prepared& prepared) const {
  records_.give_back([&](int slot) -> Body& { return bodies.at(slot); });
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    if (blocks[k] < 0) continue;
    const LaneGroup& group = groups[k / width_];
    for (int row = 0; row < group.rows; ++row)
      prepared.blocks[blocks[k]].impulse[row] =
          numbers()[lambda_index(group, row, int(k) % width_)];
  }
}

void PackedImpulses::solve(Bodies& bodies) {
  packed_.pack(bodies, blocks_of(bodies), prepared_, packing, lanes);
  for (int i = 0; i < iterations; ++i) packed_.iterate();
  packed_.unpack(bodies, prepared_);
}

}  // namespace joints
