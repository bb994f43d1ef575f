// Packs the blocks of a step into groups, and solves them.
#include "engine/simd/packed.h"

#include <algorithm>
#include <set>

namespace joints {

namespace {

BlockKind kind_of(const Bodies& bodies, const Block& block) {
  const RowTarget& target = block.target;
  const bool follows = target.follows != 0, point = block.form == Form::point;
  const bool hard = !follows && target.frequency == 0 && target.lower == -unbounded &&
                    target.upper == unbounded;
  const bool isotropic = point && bodies.at(block.body1).is_isotropic() &&
                         bodies.at(block.body2).is_isotropic();
  return {static_cast<signed char>(block.rows), point, hard, isotropic, follows};
}

// ---- the numbers of a block ---------------------------------------------------------------------

// What a record is filled from.
struct Source {
  const Block& block;
  const Row* J;
  const real* C;
  const Body &body1, &body2;
  StepTarget target;
  real h;
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
  for (int i = 3; i < N; ++i) scatter(triple(J[i].w2), rows.axis[i - 3], lane);
}

template <int N, class Number>
void fill_rows(AnyRows<N, Number>& rows, const Source& from, int lane) {
  Row response[N];
  form_responses(from.J, N, from.body1, from.body2, response);
  for (int i = 0; i < N; ++i) {
    const Row& J = from.J[i];
    scatter(typename AnyRows<N, real>::Row{triple(J.v1), triple(J.w1), triple(J.v2), triple(J.w2),
                                           triple(response[i].w1), triple(response[i].w2)},
            rows.row[i], lane);
  }
}

template <int N>
void fill_rows(SingleRows<N, real>& rows, const Source& from, int) {
  Row response[N];
  form_responses(from.J, N, from.body1, from.body2, response);
  for (int i = 0; i < N; ++i) {
    const Row &J = from.J[i], &R = response[i];
    rows.row[i] = {{triple(J.v1), 0, triple(J.w1), 0}, {triple(J.v2), 0, triple(J.w2), 0},
                   {triple(R.v1), 0, triple(R.w1), 0}, {triple(R.v2), 0, triple(R.w2), 0}};
  }
}

template <class Rows, int N, bool hard, class Number>
void fill(Record<Rows, N, hard, Number>& record, const Source& from, int lane) {
  const Block& block = from.block;
  fill_rows(record.rows, from, lane);
  for (int i = 0; i < N; ++i) {
    scatter(bias(block, i, from.C[i], from.target.rate, from.h), record.rows.bias[i], lane);
    scatter(block.impulse[i], record.impulses.lambda[i], lane);
  }
  if constexpr (!hard) {
    scatter(from.target.impulse_scale, record.bounds.impulse_scale, lane);
    scatter(from.target.lower, record.bounds.lower, lane);
    scatter(from.target.upper, record.bounds.upper, lane);
  }
}

// move_bounds() sets its bounds before every solve.
template <class Number>
void fill(FollowingRecord<Number>& record, const Source& from, int lane) {
  fill(static_cast<AnyRecord<1, false, Number>&>(record), from, lane);
  scatter(from.target.upper, record.factor, lane);
}

}  // namespace

// ---- the groups ---------------------------------------------------------------------------------

void PackedBlocks::arrange(const Bodies& bodies) {
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
  const bool automatic = packing_ == Packing::automatic;
  const auto too_empty = [&] { return 2 * pairs.size() < found.size() * std::size_t(width_); };
  width_ = lanes_ && packing_ != Packing::list ? lane_count : 1;
  if (automatic) {
    const Islands islands = islands_of(pairs, moves);
    if (width_ == 1) {
      found = interleaved(islands, 1);
    } else {
      for (const Islands& same : alike(islands, pairs, kinds))
        for (const auto& group : interleaved(same, width_)) found.push_back(group);
      if (!too_empty()) columns = columns_of(found, islands, pairs, width_);
    }
  }
  if (packing_ == Packing::colours || (automatic && too_empty()))
    found = by_colour(greedy_colours(pairs, moves), width_, kinds);
  if (packing_ == Packing::list || (automatic && too_empty())) {
    width_ = 1;
    found = one_by_one(int(pairs.size()));
  }
  records_.arrange(found, pairs, columns, moves, width_);
  groups.reserve(found.size());
  blocks.reserve(found.size() * std::size_t(width_));
  for (const auto& group : found) add_group(group);
  numbers_.shrink_to_fit();
  for (int k = int(groups.size()) - 2; k >= 0; --k)
    if (static_cast<BlockKind&>(groups[k]) == groups[k + 1]) groups[k].alike += groups[k + 1].alike;
  find_followed();
}

// Allocates the record of a group of blocks of one kind.
void PackedBlocks::add_group(const std::vector<int>& members) {
  LaneGroup group{signatures_[members[0]].kind};
  group.first = int(numbers_.size()) * lane_count;
  LaneNumber any;  // never read: only the size of the record is used
  in_record(group, any.lane, [&](auto& record) {
    group.first_lambda = group.first + int(sizeof record.rows / sizeof(real));
    numbers_.resize(numbers_.size() + (sizeof record + sizeof any - 1) / sizeof any, {});
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

// Brings the signatures up to date. \return true if none has changed
bool PackedBlocks::sign(const Bodies& bodies, const Blocks& list) {
  const std::size_t count = list.list.size();
  bool same = signatures_.size() == count;
  signatures_.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const Block& block = list.list[k];
    const Signature now{kind_of(bodies, block), bodies.at(block.body1).is_static(),
                        bodies.at(block.body2).is_static(), {block.body1, block.body2},
                        followed_row(list, int(k))};
    same = same && signatures_[k] == now;
    signatures_[k] = now;
  }
  return same;
}

void PackedBlocks::pack(const Bodies& bodies, const Blocks& list, real h, real relaxation,
                        Packing packing, bool lanes) {
  if (!sign(bodies, list) || packing != packing_ || lanes != lanes_ || groupings_ == 0) {
    packing_ = packing;
    lanes_ = lanes;
    ++groupings_;
    arrange(bodies);
  }
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    if (blocks[k] < 0) continue;
    const Block& block = list.list[std::size_t(blocks[k])];
    const LaneGroup& group = groups[k / std::size_t(width_)];
    const Source from{block, &list.J[std::size_t(block.first)], &list.C[std::size_t(block.first)],
                      bodies.at(block.body1), bodies.at(block.body2),
                      step_target(block.target, h, list.acts(h), relaxation), h};
    const int lane = int(k) % width_;
    in_record(group, numbers() + group.first, [&](auto& record) { fill(record, from, lane); });
  }
  take(bodies);  // for the masses
  run(Pass::prepare, relaxation);
}

void PackedBlocks::take(const Bodies& bodies) {
  records_.take([&](int slot) -> const Body& { return bodies.at(slot); });
}

void PackedBlocks::give_back(Bodies& bodies) const {
  records_.give_back([&](int slot) -> Body& { return bodies.at(slot); });
}

void PackedBlocks::run(Pass pass, real parameter) {
  width_ == 1 ? run_single(work(), pass, parameter) : run_lanes(work(), pass, parameter);
}

void PackedBlocks::unpack(const Blocks& list) const {
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    if (blocks[k] < 0) continue;
    const LaneGroup& group = groups[k / std::size_t(width_)];
    real* const impulse = list.list[std::size_t(blocks[k])].impulse;
    for (int row = 0; row < group.rows; ++row)
      impulse[row] = numbers()[lambda_index(group, row, int(k) % width_)];
  }
}

std::string PackedBlocks::words() const {
  if (width_ == 1) return "one block at a time";
  return std::to_string(width_) +
         (records_.columns() ? " lanes, an island in each" : " lanes, by colours");
}

std::string PackedImpulses::plan(const Bodies& bodies, const Blocks& blocks) const {
  PackedBlocks packed;
  packed.pack(bodies, blocks, 1, relaxation, packing, lanes);
  return packed.words();
}

void PackedImpulses::prepare(const Bodies& bodies, const Blocks& blocks, int first,
                             real h) {
  prepared_for(bodies, blocks, first);
  packed_.pack(bodies, blocks, h, relaxation, packing, lanes);
}

void PackedImpulses::warm_start(Bodies& bodies, real ratio) {
  blocks_of(bodies);  // refuses other bodies
  packed_.run(Pass::warm, ratio);
  if (ratio != 0) packed_.give_back(bodies);
}

void PackedImpulses::solve(Bodies& bodies) {
  const Blocks& blocks = blocks_of(bodies);
  packed_.take(bodies);
  for (int i = 0; i < iterations; ++i) packed_.run(Pass::iterate);
  packed_.give_back(bodies);
  packed_.unpack(blocks);
}

}  // namespace joints
