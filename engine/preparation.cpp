// Turns what is asked of a block, with the step's h, into what the inner loop reads.
#include "engine/preparation.h"

#include <algorithm>
#include <numbers>

namespace joints {

void Preparation::clear(int most_rows) {
  blocks.clear();
  rows.clear();
  inverse_K.clear();
  blocks.reserve(most_rows);
  rows.reserve(most_rows);
  inverse_K.reserve(6 * most_rows);
}

void Preparation::add(const Bodies& bodies, const Blocks& list, int first, real h,
                      bool row_by_row) {
  const std::size_t known = blocks.size();
  for (std::size_t k = std::size_t(first); k < list.list.size(); ++k) {
    const Block& block = list.list[k];
    const int together = row_by_row ? 1 : block.rows;
    for (int i = 0; i < block.rows; i += together)
      add_rows(bodies, list, block, i, i + together, h);
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
                           int to, real h) {
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

  const Row* const J = &list.J[out.first];
  Row response[6];
  form_responses(J, n, bodies.at(block.body1), bodies.at(block.body2), response);
  inverse_K.resize(inverse_K.size() + std::size_t(n * n));
  real* const inverse = inverse_K.data() + out.first_K;
  form_K(J, response, n, inverse);
  invert_symmetric(inverse, n);

  const real last = inverse[n * n - 1];
  const real over_last = last > 0 ? 1 / last : real(0);
  for (int i = 0; i < n; ++i)
    rows.push_back({rate * list.C[out.first + i], inverse[i * n + n - 1] * over_last,
                    response[i].w1, response[i].w2});
  if (has_last) {
    const real C = list.C[block.first + to - 1];
    const bool one_sided = target.lower == 0 && target.upper == unbounded;
    if (one_sided && C > 0) rows.back().bias = C / h;  // still a gap: it may be closed, no more
    rows.back().bias -= target.rate;
  }
  blocks.push_back(out);
}

void Preparation::start(Bodies& bodies, const Blocks& list, real ratio) {
  for (const PreparedBlock& block : blocks) {
    if (ratio == 0) {
      std::fill_n(block.impulse, block.rows, real(0));
      continue;
    }
    Body &body1 = bodies.at(block.body1), &body2 = bodies.at(block.body2);
    for (int i = 0; i < block.rows; ++i) {
      real& lambda = block.impulse[i];
      const bool live = inverse_K[block.first_K + i * block.rows + i] > 0;
      lambda = live ? ratio * lambda : 0;
      const Row& J = list.J[block.first + i];
      const PreparedRow& row = rows[block.first + i];
      body1.v += body1.inverse_mass * lambda * J.v1;
      body1.w += lambda * row.turn1;
      body2.v += body2.inverse_mass * lambda * J.v2;
      body2.w += lambda * row.turn2;
    }
  }
}

}  // namespace joints
