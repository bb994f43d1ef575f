// NNCG around SequentialImpulses::iterate().
#include "bench/next_door/nonsmooth.h"

#include <algorithm>

#include "engine/kernels.h"

namespace joints::bench {

// lambda += factor p and V += M^-1 J^T of that, within bounds that are numbers.
void NonsmoothGradients::step_along(Bodies& bodies, real factor) {
  for (const PreparedBlock& block : prepared_.blocks) {
    Body &body1 = bodies.at(block.body1), &body2 = bodies.at(block.body2);
    for (int i = 0; i < block.rows; ++i) {
      const PreparedRow& row = prepared_.rows[std::size_t(block.first + i)];
      real change = factor * p_[std::size_t(block.first + i)];
      if (i == block.rows - 1 && block.settings.follows == 0)
        change = std::clamp(block.impulse[i] + change, block.coefficients.lower,
                            block.coefficients.upper) - block.impulse[i];
      block.impulse[i] += change;
      if (!body1.is_static()) {
        body1.v += change * row.response.v1;
        body1.w += change * row.response.w1;
      }
      if (!body2.is_static()) {
        body2.v += change * row.response.v2;
        body2.w += change * row.response.w2;
      }
    }
  }
}

void NonsmoothGradients::solve(Bodies& bodies) {
  const std::vector<Row>& J = blocks_of(bodies).J;
  before_.resize(J.size());
  p_.assign(J.size(), real(0));
  K_.resize(J.size());
  for (std::size_t row = 0; row < J.size(); ++row)
    K_[row] = dot(twelve(J[row]), twelve(prepared_.rows[row].response));
  restarts = 0;
  double last = 0;  // |g|^2 of the iteration before
  for (int k = 0; k < iterations; ++k) {
    for (const PreparedBlock& block : prepared_.blocks)
      std::copy_n(block.impulse, block.rows, &before_[std::size_t(block.first)]);
    iterate(bodies);
    double size = 0;  // |g|^2, g = G(lambda) - lambda, which takes the place of lambda in before_
    for (const PreparedBlock& block : prepared_.blocks)
      for (int i = 0; i < block.rows; ++i) {
        real& g = before_[std::size_t(block.first + i)];
        g = block.impulse[i] - g;
        size += double(K_[std::size_t(block.first + i)] * g * g);
      }
    if (size == 0) return;
    if (k + 1 == iterations) return;
    const bool restart = k == 0 || size > last;
    const real factor = restart ? real(0) : real(size / last);
    restarts += restart && k > 0;
    if (!restart) step_along(bodies, factor);
    for (std::size_t row = 0; row < p_.size(); ++row) p_[row] = before_[row] + factor * p_[row];
    last = size;
  }
}

}  // namespace joints::bench
