// Prepares blocks: computes bias, scales, bounds and K^-1 from row targets and h.
#include "engine/iterative_solver.h"

#include <algorithm>
#include <stdexcept>

namespace joints {

void IterativeSolver::check() const {
  require(iterations > 0, "iterations: there must be at least one");
  require(relaxation > 0 && relaxation < 2, "relaxation", relaxation,
          "must be above 0 and below 2 [1]");
}

const Blocks& IterativeSolver::blocks_of(const Bodies& bodies) const {
  if (bodies_ != &bodies)
    throw std::logic_error("solver: was prepared for the blocks of another world");
  if (prepared_.rows.size() != blocks_->J.size())
    throw std::logic_error("solver: blocks have come or gone since they were prepared");
  return *blocks_;
}

void IterativeSolver::prepare(const Bodies& bodies, const Blocks& blocks, int first, real h) {
  bodies_ = &bodies;
  blocks_ = &blocks;
  if (first == 0) {
    prepared_.blocks.clear();
    prepared_.rows.clear();
    prepared_.inverse_K.clear();
    const std::size_t most = blocks.J.capacity();  // late limits included
    prepared_.blocks.reserve(most);
    prepared_.rows.reserve(most);
    prepared_.inverse_K.reserve(6 * most);
  }
  const std::size_t known = prepared_.blocks.size();
  for (std::size_t k = std::size_t(first); k < blocks.list.size(); ++k) {
    const Block& block = blocks.list[k];
    const int together = rows_apart() ? 1 : block.rows;
    for (int i = 0; i < block.rows; i += together) add(bodies, block, i, i + together, h);
  }
  for (std::size_t k = known; k < prepared_.blocks.size(); ++k)
    if (prepared_.blocks[k].follows != 0) prepared_.blocks[k].followed = followed_row(k);
}

// The row whose impulse bounds block k. The search starts at the nearest blocks of the list.
int IterativeSolver::followed_row(std::size_t k) const {
  const std::vector<PreparedBlock>& blocks = prepared_.blocks;
  const real* const impulse = blocks[k].impulse + blocks[k].follows;
  for (std::size_t d = 1; d < blocks.size(); ++d)
    for (const std::size_t other : {k + d, k - d}) {  // k - d wraps to a huge number below 0
      if (other >= blocks.size()) continue;
      for (int i = 0; i < blocks[other].rows; ++i)
        if (blocks[other].impulse + i == impulse) return blocks[other].first + i;
    }
  refuse("follows: the impulse that bounds a row must have a row of its own");
}

// Prepares the rows [from, to) of a block as one block.
void IterativeSolver::add(const Bodies& bodies, const Block& block, int from, int to, real h) {
  auto& [blocks, rows, inverse_K] = prepared_;
  const RowTarget& target = block.target;
  const int n = to - from;
  const bool has_last = to == block.rows;  // the row to which target and bounds belong
  PreparedBlock out{block.body1, block.body2, n, int(rows.size()), int(inverse_K.size()),
                    block.touches, 0, 1, 0, -unbounded, unbounded, block.impulse + from};

  const auto [rate, softness] = feedback(target, h);
  out.mass_scale = relaxation / (1 + softness);
  out.impulse_scale = relaxation * softness / (1 + softness);
  if (has_last && target.follows != 0) {
    require(n == 1, "follows: only a block of one row can follow another impulse");
    require(std::abs(target.follows) < 128, "follows: must be within 127 places");
    out.follows = static_cast<signed char>(target.follows);
    out.upper = target.upper;
  } else if (has_last) {
    out.lower = h * target.lower;
    out.upper = h * target.upper;
  }

  const Row* const J = &blocks_->J[out.first];
  Row response[6];
  form_responses(J, n, bodies.at(block.body1), bodies.at(block.body2), response);
  inverse_K.resize(inverse_K.size() + std::size_t(n * n));
  real* const inverse = inverse_K.data() + out.first_K;
  form_K(J, response, n, inverse);
  invert_symmetric(inverse, n);

  const real last = inverse[n * n - 1];
  const real over_last = last > 0 ? 1 / last : real(0);
  for (int i = 0; i < n; ++i)
    rows.push_back({bias(block, from + i, blocks_->C[out.first + i], rate, h),
                    inverse[i * n + n - 1] * over_last, response[i].w1, response[i].w2});
  blocks.push_back(out);
}

void IterativeSolver::warm_start(Bodies& bodies, real ratio) {
  const Blocks& blocks = blocks_of(bodies);
  for (const PreparedBlock& block : prepared_.blocks) {
    if (ratio == 0) {
      std::fill_n(block.impulse, block.rows, real(0));
      continue;
    }
    Body &body1 = bodies.at(block.body1), &body2 = bodies.at(block.body2);
    for (int i = 0; i < block.rows; ++i) {
      real& lambda = block.impulse[i];
      const bool live = prepared_.inverse_K[block.first_K + i * block.rows + i] > 0;
      lambda = live ? ratio * lambda : 0;
      const Row& J = blocks.J[block.first + i];
      const PreparedRow& row = prepared_.rows[block.first + i];
      body1.v += body1.inverse_mass * lambda * J.v1;
      body1.w += lambda * row.response_w1;
      body2.v += body2.inverse_mass * lambda * J.v2;
      body2.w += lambda * row.response_w2;
    }
  }
}

}  // namespace joints
