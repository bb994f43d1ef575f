// The step over packed blocks, and the numbers of a group.
#include "engine/simd/packed.h"

#include <algorithm>

namespace joints {

namespace {

// Whether the first three rows hold two points together and the others only turn: then two levers
// and the axes say it all. The levers are read off the rows.
bool holds_a_point(const Row* J, int rows) {
  if (rows < 3) return false;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const real one = k == i ? real(1) : real(0);
      if (J[i].v1[k] != -one || J[i].v2[k] != one) return false;
      // skew of the levers: nothing on the diagonal, the opposite across it
      if (k <= i && (J[i].w1[k] != -J[k].w1[i] || J[i].w2[k] != -J[k].w2[i])) return false;
    }
  for (int i = 3; i < rows; ++i)
    for (int k = 0; k < 3; ++k)
      if (J[i].v1[k] != 0 || J[i].v2[k] != 0 || J[i].w1[k] != -J[i].w2[k]) return false;
  return true;
}

// A kind as one number. Only blocks of one kind are solved side by side.
int kind_of(const Bodies& bodies, const Blocks& list, const PreparedBlock& block, bool follows) {
  const bool point = !follows && holds_a_point(&list.J[block.first], block.rows);
  const bool hard = block.follows == 0 && block.impulse_scale == 0 &&
                    block.lower == -unbounded && block.upper == unbounded;
  const bool isotropic = point && bodies.at(block.body1).is_isotropic() &&
                     bodies.at(block.body2).is_isotropic();
  return 64 * follows + 8 * block.rows + 4 * point + 2 * hard + isotropic;
}
// After how many numbers of a block its sums begin.
int sums_at(const LaneGroup& group) {
  const int n = group.rows;
  return group.point ? 6 + (group.isotropic ? 2 : 12) + n + 3 * (n - 3) : 19 * n;
}

}  // namespace

// The sum that block k follows, as 8 * block + row; a neighbour in the list has it, or nobody.
int PackedBlocks::find_sum(const Preparation& prepared, int k) {
  const auto& all = prepared.blocks;
  const PreparedBlock& block = all[std::size_t(k)];
  const real* const sum = block.impulse + block.follows;
  for (int d = 1; d < int(all.size()); ++d)
    for (const int other : {k + d, k - d})
      if (other >= 0 && other < int(all.size()) && sum >= all[other].impulse &&
          sum < all[other].impulse + all[other].rows)
        return 8 * other + int(sum - all[std::size_t(other)].impulse);
  return -1;
}

int PackedBlocks::size_of(const LaneGroup& group) {
  const int n = group.rows;
  return sums_at(group) + n + n * (n + 1) / 2 + (group.hard ? 0 : 3 + n) + group.follows;
}

// Where among the numbers each group finds the sums that it follows.
void PackedBlocks::place_sums() {
  sums_.clear();
  if (std::none_of(groups.begin(), groups.end(), [](const LaneGroup& g) { return g.follows; }))
    return;
  std::vector<int> place(signs_.size());  // of each block's first sum
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const LaneGroup& group = groups[k / width_];
    if (blocks[k] >= 0) place[blocks[k]] = group.first + int(k) % width_ + sums_at(group) * width_;
  }
  sums_.assign(blocks.size(), 0);
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    if (blocks[k] < 0 || !groups[k / width_].follows) continue;
    const int followed = signs_[blocks[k]].followed;
    sums_[k] = place[followed / 8] + followed % 8 * width_;
  }
}

// A record's first number: in columns the others stand lane_count apart.
real* PackedBlocks::record(int number) {
  real* const all = reinterpret_cast<real*>(records_.data());
  return columns_ ? all + number / width_ * 8 * width_ + number % width_ : all + 8 * number;
}
const real* PackedBlocks::record(int number) const {
  return const_cast<PackedBlocks*>(this)->record(number);
}

void PackedBlocks::pack(const Bodies& bodies, const Blocks& list, const Preparation& prepared,
                      Packing packing, bool lanes) {
  const int width = lanes && packing != Packing::list ? lane_count : 1;
  now_.clear();
  for (const PreparedBlock& block : prepared.blocks) {
    const int still = 2 * bodies.at(block.body1).is_static() + bodies.at(block.body2).is_static();
    const int followed = block.follows != 0 ? find_sum(prepared, int(now_.size())) : -1;
    now_.push_back({4 * kind_of(bodies, list, block, followed >= 0) + still, block.body1,
                    block.body2, followed});
  }
  if (packing != packing_ || width != width_ || now_ != signs_) {
    signs_ = now_;
    packing_ = packing;
    width_ = width;
    ++packed_;
    arrange(bodies, packing);
  }

  const int step = columns_ ? width_ : 1;
  for (std::size_t k = 0; k < slots_.size(); ++k) {
    if (slots_[k] < 0) continue;
    const Body& body = bodies.at(slots_[k]);
    real* const to = record(int(k));
    const real from[] = {body.v.x, body.v.y, body.v.z, body.inverse_mass,
                         body.w.x, body.w.y, body.w.z};
    for (int i = 0; i < 7; ++i) to[i * step] = from[i];
  }
  for (std::size_t k = 0; k < groups.size(); ++k)
    fill(bodies, list, prepared, groups[k], int(k) * width_);
}

// The numbers of a group, each block into its lane.
void PackedBlocks::fill(const Bodies& bodies, const Blocks& list, const Preparation& prepared,
                      const LaneGroup& group, int first) {
  const int n = group.rows;
  for (int lane = 0; lane < width_; ++lane) {
    if (blocks[first + lane] < 0) continue;
    const PreparedBlock& block = prepared.blocks[blocks[first + lane]];
    const Row* const J = &list.J[block.first];
    const PreparedRow* const row = &prepared.rows[block.first];
    real* to = reinterpret_cast<real*>(numbers_.data()) + group.first + lane;
    const auto put = [&](real number) {
      *to = number;
      to += width_;
    };
    const auto put_vector = [&](const vec3& a) { put(a.x), put(a.y), put(a.z); };
    if (group.point) {
      put_vector(vec3(J[2].w1.y, J[0].w1.z, J[1].w1.x));
      put_vector(-vec3(J[2].w2.y, J[0].w2.z, J[1].w2.x));
      for (const int slot : {block.body1, block.body2}) {
        const Body& body = bodies.at(slot);
        if (group.isotropic) {
          put(body.inverse_inertia_local.x);
          continue;
        }
        const mat3 I = inverse_inertia(body);
        put_vector(vec3(I[0][0], I[1][1], I[2][2]));
        put_vector(vec3(I[1][0], I[2][0], I[2][1]));
      }
      for (int i = 0; i < n; ++i) put(row[i].bias);
      for (int i = 3; i < n; ++i) put_vector(J[i].w2);
    } else {
      for (int i = 0; i < n; ++i) put(row[i].bias);
      const mat3 I1 = inverse_inertia(bodies.at(block.body1));
      const mat3 I2 = inverse_inertia(bodies.at(block.body2));
      for (int i = 0; i < n; ++i)
        for (const vec3& a : {J[i].v1, J[i].w1, J[i].v2, J[i].w2, I1 * J[i].w1, I2 * J[i].w2})
          put_vector(a);
    }
    for (int i = 0; i < n; ++i) put(block.impulse[i]);
    const real* const inverse_K = &prepared.inverse_K[block.first_K];
    for (int i = 0; i < n; ++i)
      for (int j = i; j < n; ++j) put(block.mass_scale * inverse_K[i * n + j]);
    if (group.hard) continue;
    put(block.impulse_scale);
    if (block.follows != 0) {
      const real bound = block.upper * block.impulse[block.follows];
      put(-bound), put(bound);
    } else {
      put(block.lower), put(block.upper);
    }
    for (int i = 0; i < n; ++i) put(row[i].answer);
    if (group.follows) put(block.upper);
  }
}

void PackedBlocks::iterate() {
  const LaneIteration all{groups.data(), int(groups.size()),
                      reinterpret_cast<real*>(numbers_.data()), ends.data(), sums_.data(),
                      records_.data(), columns_};
  width_ == 1 ? iterate_single(all) : iterate_lanes(all);
}

void PackedBlocks::end(Bodies& bodies, const Preparation& prepared) const {
  const int step = columns_ ? width_ : 1;
  for (std::size_t k = 0; k < slots_.size(); ++k) {
    if (slots_[k] < 0 || bodies.at(slots_[k]).is_static()) continue;
    Body& body = bodies.at(slots_[k]);
    const real* const from = record(int(k));
    body.v = vec3(from[0], from[step], from[2 * step]);
    body.w = vec3(from[4 * step], from[5 * step], from[6 * step]);
  }
  for (std::size_t k = 0; k < groups.size(); ++k)
    for (int lane = 0; lane < width_; ++lane) {
      const int block = blocks[k * width_ + lane];
      if (block < 0) continue;
      const real* from = reinterpret_cast<const real*>(numbers_.data()) + groups[k].first + lane +
                         sums_at(groups[k]) * width_;
      for (int i = 0; i < groups[k].rows; ++i, from += width_)
        prepared.blocks[block].impulse[i] = *from;
    }
}

void PackedImpulses::solve(Bodies& bodies) {
  require_prepared(bodies);
  packed_.pack(bodies, blocks(), prepared_, packing, lanes);
  for (int i = 0; i < iterations; ++i) packed_.iterate();
  packed_.end(bodies, prepared_);
}

}  // namespace joints
