// Turns what is asked of a block, with the step's h, into what the inner loop reads.
#include "engine/preparation.h"

#include <algorithm>
#include <numbers>

namespace joints {

void collect(World& world, real h, Blocks& blocks) {
  for (int slot = 0; slot < world.bodies.slots(); ++slot)
    integrate_forces(world.bodies.at(slot), world.gravity, h);
  blocks.clear();
  blocks.reserve(world.most_rows());
  for (const auto& joint : world.joints()) joint->begin_step(world.bodies, h);
  for (const auto& joint : world.joints()) joint->append(world.bodies, blocks);
}

void Preparation::clear(int most_rows) {
  blocks.clear();
  rows.clear();
  inverse_K.clear();
  blocks.reserve(most_rows);
  rows.reserve(most_rows);
  inverse_K.reserve(6 * most_rows);
}

void Preparation::add(const Bodies& bodies, const Blocks& list, int first, real h,
                      bool row_by_row, bool turns) {
  const std::size_t known = blocks.size();
  for (std::size_t k = std::size_t(first); k < list.list.size(); ++k) {
    const Block& block = list.list[k];
    if (row_by_row)
      for (int i = 0; i < block.rows; ++i) add_rows(bodies, list, block, i, i + 1, h, turns);
    else
      add_rows(bodies, list, block, 0, block.rows, h, turns);
  }
  for (std::size_t k = known; k < blocks.size(); ++k)
    if (blocks[k].follows != 0) blocks[k].followed = followed_row(k);
}

// The row whose sum block k follows: one of a neighbour in the list.
int Preparation::followed_row(std::size_t k) const {
  const real* const sum = blocks[k].impulse + blocks[k].follows;
  for (std::size_t d = 1; d < blocks.size(); ++d)
    for (const std::size_t other : {k + d, k - d}) {  // before the first: a huge number
      if (other >= blocks.size()) continue;
      for (int i = 0; i < blocks[other].rows; ++i)
        if (blocks[other].impulse + i == sum) return blocks[other].first + i;
    }
  refuse("follows: the sum that bounds a row must have a row of its own");
}

// The rows [from, to) of a block.
void Preparation::add_rows(const Bodies& bodies, const Blocks& list, const Block& block, int from,
                           int to, real h, bool turns) {
  const RowTarget& target = block.target;
  const int n = to - from;
  const bool has_last = to == block.rows;  // the row to which target and bounds belong
  PreparedBlock out{block.body1, block.body2, n, int(rows.size()), int(inverse_K.size()),
                    block.touches, 0, 1, 0, -unbounded, unbounded, block.impulse + from};

  real rate = target.beta / h;  // share of C that is removed each second
  if (target.frequency > 0) {   // a spring and damper, implicit in time (Catto 2011)
    const real omega = 2 * std::numbers::pi_v<real> * target.frequency;
    const real a1 = 2 * target.damping + h * omega, a2 = h * omega * a1;
    rate = omega / a1;
    out.mass_scale = a2 / (1 + a2);
    out.impulse_scale = 1 / (1 + a2);
  }
  out.mass_scale *= relaxation;
  out.impulse_scale *= relaxation;
  if (has_last && target.follows != 0) {
    require(n == 1, "follows: only a block of one row can follow another sum");
    out.follows = static_cast<signed char>(target.follows);
    out.upper = target.upper;
  } else if (has_last) {
    out.lower = h * target.lower;
    out.upper = h * target.upper;
  }

  inverse_K.resize(inverse_K.size() + std::size_t(n * n));
  real* inverse = inverse_K.data() + out.first_K;
  const real* const K = &list.K[block.first_K + from * block.rows + from];
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) inverse[i * n + j] = K[i * block.rows + j];
  invert_symmetric(inverse, n);

  const real last = inverse[n * n - 1];
  const real over_last = last > 0 ? 1 / last : real(0);
  rows.resize(rows.size() + std::size_t(n));
  PreparedRow* const row = &rows[std::size_t(out.first)];
  for (int i = 0; i < n; ++i) {
    row[i].bias = rate * list.C[out.first + i];
    row[i].answer = inverse[i * n + n - 1] * over_last;
  }
  if (turns) {
    const mat3 I1 = inverse_inertia(bodies.at(block.body1));
    const mat3 I2 = inverse_inertia(bodies.at(block.body2));
    for (int i = 0; i < n; ++i) {
      row[i].turn1 = I1 * list.J[out.first + i].w1;
      row[i].turn2 = I2 * list.J[out.first + i].w2;
    }
  }
  if (has_last) {
    const real C = list.C[block.first + to - 1];
    const bool one_sided = target.lower == 0 && target.upper == unbounded;
    if (one_sided && C > 0) row[n - 1].bias = C / h;  // still room: it may be used up, no more
    row[n - 1].bias -= target.rate;
  }
  blocks.push_back(out);
}

void Preparation::start(Bodies& bodies, const Blocks& list, bool warm, real scale) {
  for (const PreparedBlock& block : blocks) {
    if (!warm) {
      std::fill_n(block.impulse, block.rows, real(0));
      continue;
    }
    Body &body1 = bodies.at(block.body1), &body2 = bodies.at(block.body2);
    const mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2);
    for (int i = 0; i < block.rows; ++i) {
      real& lambda = block.impulse[i];
      const bool live = inverse_K[block.first_K + i * block.rows + i] > 0;
      lambda = live ? scale * lambda : 0;
      const Row& J = list.J[block.first + i];
      body1.v += body1.inverse_mass * lambda * J.v1;
      body1.w += lambda * (I1 * J.w1);
      body2.v += body2.inverse_mass * lambda * J.v2;
      body2.w += lambda * (I2 * J.w2);
    }
  }
}

}  // namespace joints
