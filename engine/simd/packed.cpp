// Packs the blocks of a step into groups, and solves them.
#include "engine/simd/packed.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace joints {

namespace {

BlockKind kind_of(const Block& block, const Body& body1, const Body& body2) {
  const RowSettings& target = block.settings;
  const bool follows = target.follows != 0, point = block.form == Form::point;
  const bool hard = !follows & (target.frequency == 0) & (target.lower == -unbounded) &
                    (target.upper == unbounded);  // without branches
  const bool isotropic = point && body1.is_isotropic() && body2.is_isotropic();
  const bool lone = block.rows == 1 && (body1.is_static() || body2.is_static());
  return {static_cast<unsigned char>(block.rows), point, hard, isotropic, follows, lone};
}

Member member_of(const Block& block, const Body& body1, const Body& body2) {
  const BlockKind kind = kind_of(block, body1, body2);
  const int none1 = kind.lone ? block.body2 : -1, none2 = kind.lone ? block.body1 : -1;
  return {{body1.is_static() ? none1 : block.body1, body2.is_static() ? none2 : block.body2},
          std::bit_cast<unsigned char>(kind), block.settings.follows};
}

// ---- the numbers of a block ---------------------------------------------------------------------

// The data from which a record is filled.
struct Source {
  const Block& block;
  const Row* J;
  const real* C;
  const Body &body1, &body2;
  SoftCoefficients target;
  real h;
  bool driven;  // there are static bodies with a velocity
};

// Writes the numbers of one block into one lane of its group's record; a scalar record has one.
template <BlockKind kind, class Number>
JOINTS_INLINED inline void fill_rows(PointRows<kind, Number>& rows, const Source& from, int lane) {
  const Row* const J = from.J;
  scatter(Triple<real>{J[2].w1.y, J[0].w1.z, J[1].w1.x}, rows.r1, lane);
  scatter(Triple<real>{-J[2].w2.y, -J[0].w2.z, -J[1].w2.x}, rows.r2, lane);
  if constexpr (kind.isotropic) {
    scatter(from.body1.inverse_inertia_local.x, rows.I1, lane);
    scatter(from.body2.inverse_inertia_local.x, rows.I2, lane);
  } else {
    scatter(symmetric(inverse_inertia(from.body1)), rows.I1, lane);
    scatter(symmetric(inverse_inertia(from.body2)), rows.I2, lane);
  }
  for (int i = 3; i < kind.rows; ++i) scatter(triple(J[i].w2), rows.axis[i - 3], lane);
}

// Calls f(half of a record's row, v and w of J, w times the inverse inertia, inverse mass) for each
// half row: those of body 1 and body 2, or of a lone row that of the body that moves.
template <BlockKind kind, class Rows, class F>
JOINTS_INLINED inline void each_half(Rows& rows, const Source& from, const F& f) {
  for (int i = 0; i < kind.rows; ++i)
    for (int end = 0; end < kind.ends(); ++end) {
      const bool second = kind.ends() == 2 ? end == 1 : !from.body2.is_static();
      const Body& body = second ? from.body2 : from.body1;
      const vec3& v = second ? from.J[i].v2 : from.J[i].v1;
      const vec3& w = second ? from.J[i].w2 : from.J[i].w1;
      f(rows.row[i][end], triple(v), triple(w), triple(angular_response(body, w)),
        body.inverse_mass);
    }
}

template <BlockKind kind, class Number>
JOINTS_INLINED inline void fill_rows(AnyRows<kind, Number>& rows, const Source& from, int lane) {
  each_half<kind>(rows, from,
            [&](auto& half, const auto& v, const auto& w, const auto& turned, real) JOINTS_INLINED {
    scatter(v, half.v, lane);
    scatter(w, half.w, lane);
    scatter(turned, half.response_w, lane);
  });
}

template <BlockKind kind>
JOINTS_INLINED inline void fill_rows(SingleRows<kind, real>& rows, const Source& from, int) {
  each_half<kind>(rows, from, [](auto& half, const auto& v, const auto& w, const auto& turned,
                           real inverse_mass) {
    half = {{v, 0, w, 0}, {inverse_mass * v, 0, turned, 0}};
  });
}

// A static body with a velocity, as in a belt.
bool drives(const Body& body) {
  return body.is_static() && (body.v != vec3(0) || body.w != vec3(0));
}
// The part of J V from such bodies. The iterations read zeros for static bodies.
[[gnu::noinline]] real driven_rate(const Row& J, const Body& body1, const Body& body2) {
  real rate = 0;
  if (drives(body1)) rate += dot(J.v1, body1.v) + dot(J.w1, body1.w);
  if (drives(body2)) rate += dot(J.v2, body2.v) + dot(J.w2, body2.w);
  return rate;
}

template <BlockKind kind, class Number, int N = kind.rows>
JOINTS_INLINED inline void fill(Record<kind, Number>& record, const Source& from, int lane) {
  const Block& block = from.block;
  fill_rows(record.rows, from, lane);
  const auto fill_row = [&](int i, real asked) JOINTS_INLINED {
    const real given = from.driven ? driven_rate(from.J[i], from.body1, from.body2) : real(0);
    scatter(asked + given, record.rows.bias[i], lane);
    scatter(block.impulse[i], record.lambda[i], lane);
  };
  for (int i = 0; i < N - 1; ++i) fill_row(i, feedback(block, from.C[i], from.target.bias_rate));
  fill_row(N - 1, bias(block, N - 1, from.C[N - 1], from.target.bias_rate, from.h));
  if constexpr (!kind.hard) {
    scatter(from.target.impulse_scale, record.bounds.impulse_scale, lane);
    scatter(from.target.lower, record.bounds.lower, lane);
    scatter(from.target.upper, record.bounds.upper, lane);
  }
}

}  // namespace

// ---- the groups ---------------------------------------------------------------------------------

// Updates the data on which the groups depend. \return true if nothing has changed
bool PackedBlocks::sign(const Bodies& bodies, const Blocks& list, int first) {
  const std::size_t count = list.list.size();
  bool same = members_.size() == count;
  members_.resize(count);
  for (std::size_t k = std::size_t(first); k < count; ++k) {
    const Block& block = list.list[k];
    const Member now = member_of(block, bodies.at(block.body1), bodies.at(block.body2));
    if (members_[k] == now) continue;
    members_[k] = now;
    same = false;
  }
  return same;
}

// Gives the bodies places, new ones if necessary. \return true if they are new
bool PackedBlocks::place(const Bodies& bodies) {
  if (wanted_ != Packing::automatic && wanted_ != Packing::interleaved) return false;
  moves_.clear();
  for (const Body& body : bodies) moves_.push_back(!body.is_static());
  const int width = wanted_ == Packing::automatic ? lane_count : 1;
  if (!places_.place(members_, moves_, width)) return false;
  ++placings_;
  // Lanes in use: one for each body, for each link, and for each island one of static bodies. An
  // island has one link less than bodies, so these are two per body.
  std::vector<Member> members;
  for (const BodyPair& link : places_.links()) members.push_back({link});
  LaneOrder links;
  places_.append(links, members, 0);
  const std::size_t used = 2 * std::size_t(std::count(moves_.begin(), moves_.end(), true));
  fits_lanes_ = 2 * used >= links.bodies.size() + links.blocks.size();
  if (!fits_lanes_) places_.release();
  return true;
}

// Appends groups of the blocks from number `first` on; with 0 it makes all groups anew.
void PackedBlocks::append(const Bodies& bodies, int first) {
  if (first == 0) {
    chosen_ = wanted_;
    if (wanted_ == Packing::automatic && !fits_lanes_) chosen_ = Packing::colours;
    order_.clear(wanted_ == Packing::list ? 1 : lane_count, bodies.slots());
  }
  if (chosen_ == Packing::colours) {
    colours_.append(order_, members_, first);
    const bool too_empty = 2 * members_.size() < order_.blocks.size();
    if (first > 0 || wanted_ == Packing::colours || !too_empty) return;
    chosen_ = Packing::list;
    order_.clear(1, bodies.slots());
  }
  if (chosen_ == Packing::list) return append_in_turn(order_, members_, first);
  places_.append(order_, members_, first);
}

// Makes the records of new groups. \param first 0 if all groups are new
void PackedBlocks::add_groups(const Blocks& list, int first) {
  if (first == 0) groups_.clear(), size_ = 0;
  const int before = int(groups_.size()), end = order_.groups(), width = order_.width;
  first_lambda_.resize(list.list.size());
  followed_.resize(order_.blocks.size());
  std::size_t size = 0, lambda = 0;  // of a record; from its first number to its first impulse
  for (int k = before; k < end; ++k) {
    const int* const lanes = &order_.blocks[std::size_t(k * width)];
    const int* const one = std::find_if(lanes, lanes + width, [](int block) { return block >= 0; });
    const auto kind =
        std::bit_cast<BlockKind>(static_cast<unsigned char>(members_[std::size_t(*one)].kind));
    if (k == before || kind != groups_.back()) {
      LaneNumber any;  // never read: only the size of a record is used
      in_record(kind, any.lane, [&](auto& record) {
        size = (sizeof record + sizeof any - 1) / sizeof any;
        lambda = sizeof record.rows / sizeof(real);
      });
    }
    const std::size_t begin = size_ * lane_count;
    size_ += size;
    if (numbers_.size() < size_) numbers_.resize(size_);
    if (std::find(lanes, lanes + width, -1) != lanes + width)  // an unused lane has zeros
      std::fill_n(numbers() + begin, size * lane_count, real(0));
    groups_.push_back({kind, int(begin)});
    each_block(k, [&](int number, int lane) {
      first_lambda_[std::size_t(number)] = int(begin + lambda) + lane;
    });
  }
  for (int k = before; k < end; ++k) {
    if (!groups_[k].follows) continue;
    int* const followed = &followed_[std::size_t(k * width)];
    std::iota(followed, followed + width, groups_[k].first);  // zeros of an unused lane
    each_block(k, [&](int number, int lane) {
      const auto [block, row] = followed_row(list, number);
      followed[lane] = first_lambda_[std::size_t(block)] + row * width;
    });
  }
  for (int k = end - 2; k >= before; --k)
    if (const BlockKind& kind = groups_[k]; kind == groups_[k + 1])
      groups_[k].alike += groups_[k + 1].alike;
  if (groupings_ == 1) numbers_.shrink_to_fit(), order_.ends.shrink_to_fit();
}

// ---- a step -------------------------------------------------------------------------------------

void PackedBlocks::pack(const Bodies& bodies, const Blocks& list, int first, real h,
                        real relaxation, Packing packing) {
  const bool anew = groupings_ == 0 || packing != wanted_;
  wanted_ = packing;
  if (anew || first != int(members_.size())) first = 0;
  std::size_t begin = first == 0 ? 0 : groups_.size();  // the first group to be filled
  const bool same = sign(bodies, list, first);
  if (!same || anew || (first == 0 && late_)) {
    ++groupings_;
    if (place(bodies)) begin = 0, first = 0;
    late_ = first > 0;
    append(bodies, first);
    add_groups(list, first);
  }
  const bool driven = std::any_of(bodies.begin(), bodies.end(), drives);
  const real duration = list.duration_or(h);
  for (std::size_t k = begin; k < groups_.size(); ++k) {
    // a function for each kind of record: in a single one, less would be inlined
    const auto fill_group = [&](auto& record) __attribute__((noinline)) {
      each_block(int(k), [&](int number, int lane) JOINTS_INLINED {
        const Block& block = list.list[std::size_t(number)];
        const std::size_t row = std::size_t(block.first);
        fill(record,
             {block, &list.J[row], &list.C[row], bodies.at(block.body1), bodies.at(block.body2),
              soft_coefficients(block.settings, h, duration, relaxation), h, driven},
             lane);
      });
    };
    in_record(groups_[k], numbers() + groups_[k].first, fill_group);
  }
  gather(bodies);  // for the masses
  run(Pass::prepare, relaxation, int(begin));
}

// Over the groups from number `first` on.
void PackedBlocks::run(Pass pass, real parameter, int first) {
  run_pass({groups_.data() + first, int(groups_.size()) - first, order_.width, numbers(),
            followed_.data() + first * order_.width, records_.view(order_, first)},
           pass, parameter);
}

void PackedBlocks::unpack(const Blocks& list) const {
  const int* first = first_lambda_.data();
  for (const Block& block : list.list) {
    const real* const lambda = numbers() + *first++;
    for (int row = 0; row < block.rows; ++row) block.impulse[row] = lambda[row * order_.width];
  }
}

std::string PackedBlocks::description() const {
  if (order_.width == 1) return "one block at a time";
  return std::to_string(order_.width) +
         (order_.columns ? " lanes, an island in each" : " lanes, by colours");
}

std::string PackedImpulses::description(const Bodies& bodies, const Blocks& blocks) const {
  PackedBlocks packed;
  packed.pack(bodies, blocks, 0, 1, relaxation, packing);
  return packed.description();
}

void PackedImpulses::prepare(const Bodies& bodies, const Blocks& blocks, int first,
                             real h) {
  prepared_for(bodies, blocks, first);
  packed_.pack(bodies, blocks, first, h, relaxation, packing);
}

void PackedImpulses::warm_start(Bodies& bodies, real ratio) {
  blocks_of(bodies);  // rejects other bodies
  packed_.run(Pass::warm, ratio);
  if (ratio != 0) packed_.scatter(bodies);
}

void PackedImpulses::solve(Bodies& bodies) {
  const Blocks& blocks = blocks_of(bodies);
  packed_.gather(bodies);
  for (int i = 0; i < iterations; ++i) packed_.run(Pass::iterate);
  packed_.scatter(bodies);
  packed_.unpack(blocks);
}

}  // namespace joints
